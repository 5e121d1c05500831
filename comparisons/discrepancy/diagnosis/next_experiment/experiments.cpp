#include "comparisons/discrepancy/diagnosis/next_experiment/experiments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace rebound {
namespace {

constexpr double slower = 0.3, faster = 1.6;
constexpr double heavier = 2.0;
constexpr int further_hits = 4;

PlannedExperiment history_at(const Observations& seen, std::size_t like, double factor) {
  return {
      .what = fmt::format("force history at {:.3g} m/s", factor * seen.shots[like].impact.speed),
      .records = {{.like = like, .speed_factor = factor}}};
}

/// One shot for every ball and speed at hand that has a history.
std::vector<PlannedRecord> records_at_hand(const Observations& seen) {
  std::vector<PlannedRecord> records;
  std::set<std::pair<std::size_t, double>> known;
  for (std::size_t i = 0; i < seen.shots.size(); ++i)
    if (seen.shots[i].has_history() &&
        known.emplace(seen.shots[i].ball, seen.shots[i].impact.speed).second)
      records.push_back({.like = i});
  return records;
}

}  // namespace

std::vector<PlannedExperiment> possible_experiments(const Observations& seen) {
  if (seen.shots.empty()) return {};
  const auto by_speed = [](const MeasuredImpact& a, const MeasuredImpact& b) {
    return a.impact.speed < b.impact.speed;
  };
  const auto [low, high] = std::minmax_element(seen.shots.begin(), seen.shots.end(), by_speed);
  const auto slow = static_cast<std::size_t>(low - seen.shots.begin());
  const auto fast = static_cast<std::size_t>(high - seen.shots.begin());
  const std::string at_fastest = fmt::format(" at {:.3g} m/s", seen.shots[fast].impact.speed);
  const std::vector<PlannedRecord> at_hand = records_at_hand(seen);
  std::vector<PlannedExperiment> all;
  if (at_hand.empty()) {
    all.push_back(history_at(seen, slow, 1.0));
    if (fast != slow) all.push_back(history_at(seen, fast, 1.0));
  } else {
    all.push_back({.what = fmt::format("{} further hits at every speed", further_hits),
                   .records = at_hand,
                   .repeats = further_hits});
  }
  all.push_back(history_at(seen, slow, slower));
  all.push_back(history_at(seen, fast, faster));
  all.push_back({.what = "a ball of twice the mass on the same contact" + at_fastest,
                 .records = {{.like = fast, .mass_factor = heavier}}});
  if (std::none_of(seen.shots.begin(), seen.shots.end(), [](const MeasuredImpact& shot) {
        return shot.deflection_noise.deviation > 0.0;
      }))
    all.push_back(
        {.what = "deflection over time beside the force" + at_fastest,
         .records = {{.like = fast}, {.quantity = RecordedQuantity::deflection, .like = fast}}});
  if (seen.compressions.empty())
    all.push_back({.what = "a slow compression to the deflection of the impact" + at_fastest,
                   .records = {{.quantity = RecordedQuantity::slow_force, .like = fast}}});
  return all;
}

}  // namespace rebound
