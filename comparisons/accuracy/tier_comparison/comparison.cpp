#include "comparisons/accuracy/tier_comparison/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr double same_number = 1e-9;

bool alike(double a, double b) {
  return std::abs(a - b) <= same_number * std::max(std::abs(a), std::abs(b));
}

SharedBasis basis_of(const Discretisation& a, const Discretisation& b) {
  if (a.scheme != b.scheme || a.cells != b.cells || a.vertices != b.vertices)
    return SharedBasis::nothing;
  return alike(a.smallest_step, b.smallest_step) ? SharedBasis::discretisation : SharedBasis::mesh;
}

/// Half widths of both runs. On one mesh that of the baseline stands for both: a fault that spoils
/// the accuracy of a run must not widen its own tolerance.
double tolerance_of(const RecordedScalar& before, const RecordedScalar& now, SharedBasis basis) {
  switch (basis) {
    case SharedBasis::discretisation: return 2.0 * before.rounding;
    case SharedBasis::mesh: return 2.0 * before.step;
    case SharedBasis::nothing: return before.numerical + now.numerical;
  }
  return 0.0;
}

const TierRecord* record_like(const std::vector<TierRecord>& records, const TierRecord& one) {
  for (const TierRecord& record : records)
    if (record.tier == one.tier && alike(record.speed, one.speed)) return &record;
  return nullptr;
}

std::string place_of(const TierRecord& record) {
  return fmt::format("{} at {:g} m/s", record.tier, record.speed);
}

void compare_with_baseline(const TierRecord& now, const TierRecord& before,
                           CaseComparison& comparison) {
  if (now.separation != before.separation)
    comparison.remarks.push_back(fmt::format("{}: contact ends by {}, in the baseline by {}",
                                             place_of(now), now.separation, before.separation));
  if (now.input_sha256 != before.input_sha256)
    comparison.remarks.push_back(
        fmt::format("{}: its impact file is another than that of the baseline", place_of(now)));
  const SharedBasis basis = basis_of(now.discretisation, before.discretisation);
  if (basis == SharedBasis::nothing)
    comparison.remarks.push_back(
        fmt::format("{}: {} cells, in the baseline {}; compared within the numerical error",
                    place_of(now), now.discretisation.cells, before.discretisation.cells));
  for (const std::string& key : compared_keys()) {
    const RecordedScalar &a = before.scalars.at(key), &b = now.scalars.at(key);
    comparison.movements.push_back({.tier = now.tier,
                                    .speed = now.speed,
                                    .key = key,
                                    .before = a.value,
                                    .now = b.value,
                                    .tolerance = tolerance_of(a, b, basis),
                                    .measured_by = basis});
  }
}

void compare_tiers(const CompareCase& one, CaseComparison& comparison) {
  for (const TierRecord& lumped : comparison.records) {
    if (lumped.tier != "lumped") continue;
    for (const TierRecord& fem : comparison.records) {
      if (fem.tier != "fem" || !alike(fem.speed, lumped.speed)) continue;
      for (const std::string& key : compared_keys()) {
        const RecordedScalar &a = lumped.scalars.at(key), &b = fem.scalars.at(key);
        TierGap gap{.speed = fem.speed,
                    .key = key,
                    .lumped = a.value,
                    .fem = b.value,
                    .tolerance = a.numerical + b.numerical,
                    .allowed_share = {}};
        if (const auto known = one.agreement.find(key); known != one.agreement.end())
          gap.allowed_share = known->second;
        comparison.gaps.push_back(gap);
      }
    }
  }
}

}  // namespace

bool CaseComparison::passes() const {
  return std::none_of(movements.begin(), movements.end(),
                      [](const Movement& one) { return one.has_moved(); }) &&
         std::none_of(gaps.begin(), gaps.end(), [](const TierGap& one) { return one.fails(); });
}

std::vector<std::string> CaseComparison::moved_tiers() const {
  std::vector<std::string> tiers;
  for (const Movement& one : movements)
    if (one.has_moved() && std::find(tiers.begin(), tiers.end(), one.tier) == tiers.end())
      tiers.push_back(one.tier);
  return tiers;
}

CaseComparison compare_case(const CompareCase& one, const std::vector<TierRecord>& now,
                            const std::vector<TierRecord>& before) {
  CaseComparison comparison{.name = one.name, .records = now};
  if (!before.empty()) {
    const bool same_set = now.size() == before.size() &&
                          std::all_of(now.begin(), now.end(), [&](const TierRecord& record) {
                            return record_like(before, record) != nullptr;
                          });
    if (!same_set)
      throw Error(ExitCode::bad_input,
                  "the baseline is of other tiers or speeds than the case; --record writes it anew",
                  {.file = {}, .key = "case", .value = one.name, .allowed = {}});
    for (const TierRecord& record : now)
      compare_with_baseline(record, *record_like(before, record), comparison);
  }
  compare_tiers(one, comparison);
  return comparison;
}

}  // namespace rebound
