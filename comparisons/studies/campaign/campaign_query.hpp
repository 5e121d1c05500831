#pragma once

#include <filesystem>
#include <string>

#include "comparisons/studies/campaign/campaign.hpp"

namespace rebound {

/// Members of a campaign that are in the store, as CSV with 17 digits: number, factors, scalars,
/// failure; and how many there are.
struct CampaignTable {
  std::string csv;
  std::size_t members = 0, found = 0, failed = 0;
};
CampaignTable query_campaign(const Campaign& campaign, const std::filesystem::path& store);

/// The campaign whose results a store holds.
/// Errors: Error(bad_input) where it holds those of several: the file is then to be named.
Campaign stored_campaign(const std::filesystem::path& store);

}  // namespace rebound
