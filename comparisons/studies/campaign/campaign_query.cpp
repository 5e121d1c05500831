#include "comparisons/studies/campaign/campaign_query.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "comparisons/studies/campaign/result_store.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr std::size_t members_at_once = 4096;

std::string number_cell(double value) {
  return std::isnan(value) ? "," : fmt::format(",{:.17g}", value);
}

std::string text_cell(std::string text) {
  if (text.empty()) return ",";
  std::replace(text.begin(), text.end(), '"', '\'');
  return ",\"" + text + "\"";
}

/// Named values of all members of a table, each in the column of its name.
class NamedColumns {
 public:
  void add(const std::vector<NamedValue>& values) {
    for (const NamedValue& value : values)
      if (places_.try_emplace(value.name, names_.size()).second) names_.push_back(value.name);
  }
  const std::vector<std::string>& names() const { return names_; }

  std::string cells(const std::vector<NamedValue>& values) const {
    std::vector<std::string> cells(names_.size(), ",");
    for (const auto& [name, value] : values) {
      const double* number = std::get_if<double>(&value);
      cells[places_.at(name)] =
          number ? number_cell(*number) : text_cell(std::get<std::string>(value));
    }
    std::string all;
    for (const std::string& cell : cells) all += cell;
    return all;
  }

 private:
  std::map<std::string, std::size_t> places_;
  std::vector<std::string> names_;
};

/// A member that was found.
struct FoundMember {
  std::size_t number;
  std::vector<double> factors;
  MemberResult result;
};

std::string csv_of(const Campaign& campaign, const std::vector<FoundMember>& found) {
  NamedColumns columns;
  for (const FoundMember& member : found) columns.add(member.result.values);
  std::string csv = "member";
  for (const CampaignFactor& factor : campaign.design().factors) csv += "," + factor.key;
  if (campaign.of_impacts())
    for (const char* name : member_scalars) csv += std::string(",") + name;
  for (const std::string& name : columns.names()) csv += "," + name;
  csv += ",failure\n";
  for (const auto& [number, factors, result] : found) {
    const bool failed = !result.failure.empty();
    csv += fmt::format("{}", number);
    for (const double value : factors) csv += fmt::format(",{:.17g}", value);
    if (campaign.of_impacts())
      for (const double value : result.scalars) csv += failed ? "," : number_cell(value);
    csv += columns.cells(result.values) + text_cell(result.failure) + "\n";
  }
  return csv;
}

}  // namespace

CampaignTable query_campaign(const Campaign& campaign, const std::filesystem::path& store) {
  std::vector<ResultStore> stores;
  for (const auto& file : store_files(store))
    stores.emplace_back(file, ResultStore::Access::read, campaign.program());
  CampaignTable table;
  table.members = campaign.size();
  std::vector<FoundMember> found;
  DesignSampler sampler(campaign.design());
  for (std::size_t first = 0; first < table.members; first += members_at_once) {
    std::vector<std::size_t> numbers;
    for (std::size_t i = first; i < std::min(first + members_at_once, table.members); ++i)
      numbers.push_back(i);
    const CampaignMembers members = make_members(campaign, sampler, numbers);
    for (std::size_t i = 0; i < members.size(); ++i) {
      std::optional<MemberResult> result;
      for (auto one = stores.begin(); one != stores.end() && !result; ++one)
        result = one->find(members[i]->key);
      if (!result) continue;
      ++table.found;
      if (!result->failure.empty()) ++table.failed;
      found.push_back({numbers[i], members[i]->values, std::move(*result)});
    }
  }
  table.csv = csv_of(campaign, found);
  return table;
}

Campaign stored_campaign(const std::filesystem::path& store) {
  const std::string program = running_program();
  std::map<std::string, CampaignText> found;  // by both texts: shards hold the same one
  for (const auto& file : store_files(store))
    for (CampaignText& text : ResultStore(file, ResultStore::Access::read, program).campaigns())
      found.try_emplace(text.text + text.base_text, std::move(text));
  if (found.size() != 1)
    throw Error(
        ExitCode::bad_input,
        fmt::format("the store holds results of {} campaigns: name the file of one", found.size()),
        {.file = store.string()});
  return Campaign::parse(std::move(found.begin()->second));
}

}  // namespace rebound
