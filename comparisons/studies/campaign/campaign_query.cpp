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

std::string row(std::size_t number, const std::vector<double>& values, const MemberResult& result) {
  std::string text = fmt::format("{}", number);
  for (const double value : values) text += fmt::format(",{:.17g}", value);
  const bool failed = !result.failure.empty();
  for (const double value : result.scalars)
    text += failed || std::isnan(value) ? "," : fmt::format(",{:.17g}", value);
  std::string failure = result.failure;
  std::replace(failure.begin(), failure.end(), '"', '\'');
  return text + (failed ? fmt::format(",\"{}\"\n", failure) : ",\n");
}

}  // namespace

CampaignTable query_campaign(const Campaign& campaign, const std::filesystem::path& store) {
  std::vector<ResultStore> stores;
  for (const auto& file : store_files(store))
    stores.emplace_back(file, ResultStore::Access::read, campaign.program());
  CampaignTable table;
  table.members = campaign.size();
  table.csv = "member";
  for (const CampaignFactor& factor : campaign.design().factors) table.csv += "," + factor.key;
  for (const char* name : member_scalars) table.csv += std::string(",") + name;
  table.csv += ",failure\n";
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
      table.csv += row(numbers[i], members[i]->values, *result);
    }
  }
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
