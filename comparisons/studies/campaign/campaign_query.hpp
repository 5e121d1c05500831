#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "comparisons/io/array_files/interface.hpp"
#include "comparisons/studies/campaign/campaign.hpp"

namespace rebound {

/// Members of a campaign that are in the store: number, factors, scalars or named values, failure,
/// a column each; and how many there are. NaN is no number.
struct CampaignTable {
  std::vector<ArrayColumn> columns;
  std::size_t members = 0, found = 0, failed = 0, rows = 0;
};
CampaignTable query_campaign(const Campaign& campaign, const std::filesystem::path& store);

/// Traces of the members that are in the store, one below the other: member number, then the
/// columns of a trace; NaN where a member's trace has none of that name. Errors: Error(bad_input)
/// for a campaign that keeps no traces.
CampaignTable query_traces(const Campaign& campaign, const std::filesystem::path& store);

/// With 17 digits; texts in double quotes, and with single ones inside.
std::string csv_of(const CampaignTable& table);

/// One data set a column, and the texts of campaign and base file in the group "about".
/// Errors: those of write_array_table.
void write_hdf5(const CampaignTable& table, const Campaign& campaign,
                const std::filesystem::path& file);

/// The campaign whose results a store holds.
/// Errors: Error(bad_input) where it holds those of several: the file is then to be named.
Campaign stored_campaign(const std::filesystem::path& store);

}  // namespace rebound
