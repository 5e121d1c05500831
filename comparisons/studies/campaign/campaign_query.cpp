#include "comparisons/studies/campaign/campaign_query.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>

#include "comparisons/io/laboratory/array_table.hpp"
#include "comparisons/io/result_store/result_store.hpp"
#include "comparisons/io/result_store/running_program.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr std::size_t members_at_once = 4096;

/// Columns that fill row by row; a value that a row does not have is NaN or empty.
class Columns {
 public:
  /// A column that is there without rows, too.
  void declare(const std::string& name) { column(name); }
  void add_row() { ++rows_; }
  void add(const std::string& name, double number) { column(name).numbers.back() = number; }
  void add(const std::string& name, const std::string& text) {
    ArrayColumn& one = column(name);
    one.texts.resize(rows_);
    one.texts.back() = text;
  }
  /// All of them, as long as there are rows; those of texts without numbers.
  std::vector<ArrayColumn> take() {
    for (ArrayColumn& one : columns_) {
      if (one.texts.empty()) {
        one.numbers.resize(rows_, none);
        continue;
      }
      one.texts.resize(rows_);
      one.numbers.clear();
    }
    return std::move(columns_);
  }

 private:
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  ArrayColumn& column(const std::string& name) {
    const auto [at, added] = places_.try_emplace(name, columns_.size());
    if (added) columns_.push_back({.name = name});
    ArrayColumn& one = columns_[at->second];
    one.numbers.resize(rows_, none);
    return one;
  }

  std::map<std::string, std::size_t> places_;
  std::vector<ArrayColumn> columns_;
  std::size_t rows_ = 0;
};

void add_member(const Campaign& campaign, std::size_t number, const std::vector<double>& factors,
                const MemberResult& result, Columns& columns, std::vector<std::string>& failures) {
  columns.add_row();
  columns.add("member", static_cast<double>(number));
  for (std::size_t i = 0; i < factors.size(); ++i)
    columns.add(campaign.design().factors[i].key, factors[i]);
  const bool failed = !result.failure.empty();
  for (std::size_t i = 0; campaign.of_impacts() && i < member_scalars.size(); ++i)
    columns.add(member_scalars[i],
                failed ? std::numeric_limits<double>::quiet_NaN() : result.scalars[i]);
  for (const NamedValue& named : result.values)
    std::visit([&](const auto& value) { columns.add(named.name, value); }, named.value);
  failures.push_back(result.failure);
}

std::string text_cell(std::string text) {
  if (text.empty()) return {};
  std::replace(text.begin(), text.end(), '"', '\'');
  return "\"" + text + "\"";
}

}  // namespace

namespace {

using SeenMember = std::function<void(std::size_t number, const std::vector<double>& factors,
                                      const MemberResult& result)>;

/// Shows every member that a store has; counts them in `table`.
void each_member(const Campaign& campaign, const std::filesystem::path& store, CampaignTable& table,
                 const SeenMember& seen) {
  std::vector<ResultStore> stores;
  for (const auto& file : store_files(store))
    stores.emplace_back(file, ResultStore::Access::read, campaign.program());
  table.members = campaign.size();
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
      seen(numbers[i], members[i]->values, *result);
    }
  }
}

}  // namespace

CampaignTable query_campaign(const Campaign& campaign, const std::filesystem::path& store) {
  CampaignTable table;
  Columns columns;
  std::vector<std::string> failures;
  columns.declare("member");
  for (const CampaignFactor& factor : campaign.design().factors) columns.declare(factor.key);
  if (campaign.of_impacts())
    for (const char* name : member_scalars) columns.declare(name);
  each_member(
      campaign, store, table,
      [&](std::size_t number, const std::vector<double>& factors, const MemberResult& result) {
        add_member(campaign, number, factors, result, columns, failures);
      });
  table.columns = columns.take();
  table.columns.push_back({.name = "failure", .texts = std::move(failures)});
  table.rows = table.found;
  return table;
}

CampaignTable query_traces(const Campaign& campaign, const std::filesystem::path& store) {
  if (!campaign.keeps_traces())
    throw Error(ExitCode::bad_input, "this campaign keeps no traces",
                {.file = campaign.text().file, .key = "traces", .allowed = "traces = true"});
  CampaignTable table;
  Columns columns;
  columns.declare("member");
  each_member(campaign, store, table,
              [&](std::size_t number, const std::vector<double>&, const MemberResult& result) {
                const std::size_t samples =
                    result.trace.empty() ? 0 : result.trace.front().values.size();
                for (std::size_t i = 0; i < samples; ++i) {
                  columns.add_row();
                  columns.add("member", static_cast<double>(number));
                  for (const TraceColumn& column : result.trace)
                    columns.add(column.name, column.values.at(i));
                }
                table.rows += samples;
              });
  table.columns = columns.take();
  return table;
}

std::string csv_of(const CampaignTable& table) {
  std::string csv;
  for (const ArrayColumn& column : table.columns) csv += (csv.empty() ? "" : ",") + column.name;
  csv += "\n";
  for (std::size_t row = 0; row < table.rows; ++row) {
    for (const ArrayColumn& column : table.columns) {
      if (&column != table.columns.data()) csv += ",";
      if (!column.texts.empty())
        csv += text_cell(column.texts[row]);
      else if (!std::isnan(column.numbers[row]))
        csv += fmt::format("{:.17g}", column.numbers[row]);
    }
    csv += "\n";
  }
  return csv;
}

void write_hdf5(const CampaignTable& table, const Campaign& campaign,
                const std::filesystem::path& file) {
  write_array_table(file, table.columns,
                    {{"campaign", campaign.text().text},
                     {"base", campaign.text().base_text},
                     {"program", campaign.program()}});
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
