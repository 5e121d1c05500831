#include "tests/verification/fem/coverage/repetition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <vector>

#include "tests/verification/fem/coverage/families.hpp"

namespace rebound {
namespace {

bool same_family(const CoverageRow& a, const CoverageRow& b) {
  return a.number == b.number && a.use == b.use && a.cells == b.cells;
}

/// Judged families of the plan that `stored` has, as many as asked for.
std::vector<PlannedFamily> drawn(const std::vector<CoverageRow>& stored, int count) {
  std::vector<PlannedFamily> families = planned_families();
  std::erase_if(families, [&](const PlannedFamily& family) {
    return family.row.use != FamilyUse::bars ||
           std::none_of(stored.begin(), stored.end(),
                        [&](const CoverageRow& row) { return same_family(row, family.row); });
  });
  std::shuffle(families.begin(), families.end(), std::mt19937_64(20261125));
  families.resize(std::min(families.size(), static_cast<std::size_t>(count)));
  return families;
}

/// What changed of one scalar, in shares of the value, of the bar and of the bar.
struct Difference {
  double value = 0.0, value_in_bars = 0.0, bar = 0.0;
  bool verdict = false;

  Difference(const JudgedBar& before, const JudgedBar& now)
      : value(now.row->values.fine / before.row->values.fine - 1.0),
        value_in_bars((now.row->values.fine - before.row->values.fine) / before.bar),
        bar(now.bar / before.bar - 1.0),
        verdict(now.covers() != before.covers()) {}
};

}  // namespace

int repeat_families(const std::filesystem::path& table, int count) {
  const std::vector<CoverageRow> stored = read_coverage(table);
  const std::vector<JudgedBar> before = judge_bars(stored);
  std::vector<CoverageRow> again = stored;
  fmt::print(
      "point  cells  scalar                          value      in bars    bar        covers\n");
  int flipped = 0;
  double largest_in_bars = 0.0, largest_of_bar = 0.0;
  for (const PlannedFamily& family : drawn(stored, count)) {
    for (const CoverageRow& row : run_family(family))
      for (CoverageRow& known : again)
        if (same_family(known, row) && known.quantity == row.quantity) known.values = row.values;
    const std::vector<JudgedBar> now = judge_bars(again);
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (!same_family(*before[i].row, family.row)) continue;
      const Difference moved(before[i], now[i]);
      flipped += moved.verdict;
      largest_in_bars = std::max(largest_in_bars, std::abs(moved.value_in_bars));
      largest_of_bar = std::max(largest_of_bar, std::abs(moved.bar));
      fmt::print("{:5}  {:5}  {:27}  {:9.1e}  {:9.1e}  {:9.1e}  {}{}\n", before[i].row->number,
                 before[i].row->cells, before[i].row->quantity, moved.value, moved.value_in_bars,
                 moved.bar, before[i].covers() ? "yes" : "no", moved.verdict ? ", now not so" : "");
    }
    std::fflush(stdout);
  }
  fmt::print("largest: value {:.1e} bars, bar {:.1e} of itself; {} verdicts differ\n",
             largest_in_bars, largest_of_bar, flipped);
  return flipped;
}

}  // namespace rebound
