#include "comparisons/studies/reproduce/repair_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

namespace rebound {
namespace {

/// Where most of several lists of intervals hold at once.
struct Agreement {
  Interval where;
  std::size_t count = 0;
};

/// Sweeps over the ends of all intervals. Lists that hold everywhere are `always`.
/// Among equal counts the one nearest to `preferred` wins.
Agreement most_common(const std::vector<std::vector<Interval>>& lists, std::size_t always,
                      double preferred) {
  std::vector<double> ends;
  for (const auto& list : lists)
    for (const Interval& interval : list) {
      ends.push_back(interval.low);
      ends.push_back(interval.high);
    }
  std::sort(ends.begin(), ends.end());
  const auto count_at = [&](double value) {
    std::size_t count = always;
    for (const auto& list : lists)
      count += std::any_of(list.begin(), list.end(), [&](const Interval& interval) {
        return interval.low <= value && value <= interval.high;
      });
    return count;
  };
  const auto distance = [&](const Interval& interval) {
    const double nearest = std::clamp(preferred, interval.low, interval.high);
    return std::abs(std::log(nearest / preferred));
  };
  Agreement best{{preferred, preferred}, always};
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const Interval piece{ends[i], ends[i + 1]};
    const std::size_t count = count_at(piece.middle());
    const bool joins = count == best.count && piece.low == best.where.high;
    if (joins && count > always) best.where.high = piece.high;
    if (count > best.count || (count == best.count && distance(piece) < distance(best.where)))
      best = {piece, count};
  }
  return best;
}

/// Index of the input of that quantity in a row, if the row has it.
std::optional<std::size_t> find_input(const DerivedRow& row, const std::string& quantity) {
  for (std::size_t i = 0; i < row.inputs.size(); ++i)
    if (row.inputs[i].quantity == quantity) return i;
  return std::nullopt;
}

bool follows(const DerivedRow& row, Strictness strictness) {
  const Verdict verdict = evaluate(row).verdict;
  return verdict == Verdict::reproduces ||
         (strictness == Strictness::within_rounding && verdict == Verdict::within_rounding);
}

/// Mean of the printed values, and whether they are one and the same number.
struct PrintedValues {
  double mean = 0.0;
  bool all_equal = true;
  std::size_t rows = 0;
};

PrintedValues printed_values(const Block& block, const std::string& quantity) {
  PrintedValues values;
  double first = 0.0;
  for (const DerivedRow& row : block.rows)
    if (const auto input = find_input(row, quantity)) {
      const double value = row.inputs[*input].printed.value;
      if (values.rows++ == 0) first = value;
      values.all_equal = values.all_equal && value == first;
      values.mean += value;
    }
  values.mean /= static_cast<double>(values.rows);
  return values;
}

/// Where most rows of the block agree on a changed input, looked for in `within`.
Agreement agreement(const Block& block, const std::string& quantity, Change change,
                    Strictness strictness, const Interval& within) {
  std::vector<std::vector<Interval>> lists;
  std::size_t untouched = 0;
  for (const DerivedRow& row : block.rows) {
    const auto input = find_input(row, quantity);
    if (!input) {
      untouched += follows(row, strictness) ? 1 : 0;
      continue;
    }
    const double unit = change == Change::common_factor ? row.inputs[*input].printed.value : 1.0;
    lists.emplace_back();
    for (const Interval& accepted : accepted_values(row, *input, strictness)) {
      const Interval clipped{std::max(accepted.low / unit, within.low),
                             std::min(accepted.high / unit, within.high)};
      if (clipped.low <= clipped.high) lists.back().push_back(clipped);
    }
  }
  const double preferred =
      change == Change::common_factor ? 1.0 : printed_values(block, quantity).mean;
  return most_common(lists, untouched, preferred);
}

Repair try_change(const Block& block, const std::string& quantity, Change change) {
  constexpr double anywhere = std::numeric_limits<double>::infinity();
  const Agreement wide =
      agreement(block, quantity, change, Strictness::within_rounding, {-anywhere, anywhere});
  const Agreement exact = agreement(block, quantity, change, Strictness::to_the_digit, wide.where);
  const double printed =
      change == Change::common_factor ? 1.0 : printed_values(block, quantity).mean;
  return {.input = quantity,
          .change = change,
          .needed = wide.where,
          .repaired = wide.count,
          .to_the_digit = exact.count,
          .best = exact.where,
          .distance = std::abs(std::log(wide.where.middle() / printed))};
}

bool better(const Repair& one, const Repair& other) {
  if (one.repaired != other.repaired) return one.repaired > other.repaired;
  if (one.to_the_digit != other.to_the_digit) return one.to_the_digit > other.to_the_digit;
  return one.distance < other.distance;
}

std::vector<Block> split(const std::vector<DerivedRow>& rows, const auto& name_of_part) {
  std::vector<Block> blocks;
  for (const DerivedRow& row : rows) {
    const std::string name = row.key.table + ", " + name_of_part(row);
    const auto same = [&](const Block& block) { return block.name == name; };
    auto found = std::find_if(blocks.begin(), blocks.end(), same);
    if (found == blocks.end()) found = blocks.insert(blocks.end(), {name, {}});
    found->rows.push_back(row);
  }
  return blocks;
}

std::vector<BlockSearch> search_blocks(const std::vector<Block>& blocks) {
  std::vector<BlockSearch> searches;
  for (const Block& block : blocks) {
    if (block.rows.size() < 2) continue;
    const BlockSearch search = search_repairs(block);
    if (search.differing > 0) searches.push_back(search);
  }
  return searches;
}

bool any_repair(const std::vector<BlockSearch>& searches) {
  return std::any_of(searches.begin(), searches.end(),
                     [](const BlockSearch& search) { return !search.repairs.empty(); });
}

}  // namespace

BlockSearch search_repairs(const Block& block) {
  BlockSearch search{.block = block.name, .rows = block.rows.size()};
  std::set<std::string> quantities;
  for (const DerivedRow& row : block.rows) {
    search.differing += follows(row, Strictness::within_rounding) ? 0 : 1;
    for (const Input& input : row.inputs) quantities.insert(input.quantity);
  }
  if (search.differing == 0) return search;
  std::vector<Repair> tried;
  for (const std::string& quantity : quantities) {
    const PrintedValues values = printed_values(block, quantity);
    if (values.rows < 2) continue;
    tried.push_back(try_change(block, quantity, Change::common_value));
    // Of one and the same printed number, value and factor say the same.
    if (!values.all_equal) tried.push_back(try_change(block, quantity, Change::common_factor));
  }
  std::sort(tried.begin(), tried.end(), better);
  if (!tried.empty()) search.nearest = tried.front();
  for (const Repair& repair : tried)
    if (repair.repaired == block.rows.size()) search.repairs.push_back(repair);
  return search;
}

std::vector<BlockSearch> search_table(const std::vector<DerivedRow>& rows) {
  std::vector<BlockSearch> whole = search_blocks({{rows.front().key.table, rows}});
  if (whole.empty() || any_repair(whole)) return whole;
  const auto by_core =
      search_blocks(split(rows, [](const DerivedRow& row) { return scope_of(row.key.core, 0.0); }));
  const auto by_speed =
      search_blocks(split(rows, [](const DerivedRow& row) { return scope_of("", row.key.speed); }));
  const auto& parts = any_repair(by_core) ? by_core : by_speed;
  whole.insert(whole.end(), parts.begin(), parts.end());
  return whole;
}

}  // namespace rebound
