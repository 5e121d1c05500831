#include "comparisons/discrepancy/inspection/shots_together.hpp"

#include <algorithm>
#include <cmath>

namespace rebound {
namespace {

/// Shots of nearly one speed together, fastest last.
std::vector<std::vector<std::size_t>> groups_by_speed(const std::vector<InspectedShot>& shots) {
  std::vector<std::size_t> order(shots.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return shots[a].speed < shots[b].speed; });
  constexpr double alike = 0.02;
  std::vector<std::vector<std::size_t>> groups;
  for (const std::size_t i : order) {
    if (groups.empty() || shots[i].speed > (1.0 + alike) * shots[groups.back().front()].speed)
      groups.emplace_back();
    groups.back().push_back(i);
  }
  return groups;
}

/// A stated restitution against the straight line between its neighbours in speed.
DataCheck between_neighbours(const MeasuredImpact& low, const MeasuredImpact& shot,
                             const MeasuredImpact& high) {
  // How much a restitution may bend: |v² d²e/dv²|, 0.05 for e = 1 - C v^(1/5) at e = 0.7.
  constexpr double largest_bend = 0.5;
  const double v = shot.impact.speed, below = v - low.impact.speed, above = high.impact.speed - v;
  const double share = below + above > 0.0 ? below / (below + above) : 0.5;
  const double bend = 0.5 * largest_bend * below * above / (v * v);
  return {.what = "restitution-over-speed",
          .of = shot.label,
          .unit = "",
          .measured = *shot.restitution.value,
          .expected = (1.0 - share) * *low.restitution.value + share * *high.restitution.value,
          .error = std::hypot(*shot.restitution.uncertainty,
                              std::hypot((1.0 - share) * *low.restitution.uncertainty,
                                         share * *high.restitution.uncertainty),
                              bend)};
}

std::vector<DataCheck> all_between_neighbours(const std::vector<const MeasuredImpact*>& shots) {
  std::vector<DataCheck> checks;
  for (std::size_t i = 1; i + 1 < shots.size(); ++i)
    checks.push_back(between_neighbours(*shots[i - 1], *shots[i], *shots[i + 1]));
  return checks;
}

}  // namespace

void add_repeats(Inspection& found) {
  for (const auto& group : groups_by_speed(found.shots)) {
    if (group.size() < 2) continue;
    for (const InspectedNumber& first : found.shots[group.front()].numbers) {
      std::vector<double> values;
      double speed = 0.0, squares = 0.0;
      bool all_state_errors = true;
      for (const std::size_t i : group)
        for (const InspectedNumber& number : found.shots[i].numbers)
          if (number.key == first.key) {
            values.push_back(number.value);
            speed += found.shots[i].speed;
            all_state_errors = all_state_errors && number.uncertainty;
            squares += std::pow(number.uncertainty.value_or(0.0), 2);
          }
      const auto count = static_cast<double>(values.size());
      if (values.size() < 2) continue;
      double mean = 0.0, variance = 0.0;
      for (const double value : values) mean += value / count;
      for (const double value : values) variance += std::pow(value - mean, 2) / (count - 1.0);
      RepeatedSpeed repeat{.speed = speed / count,
                           .key = first.key,
                           .count = values.size(),
                           .mean = mean,
                           .scatter = std::sqrt(variance),
                           .typical_error = {}};
      if (all_state_errors) repeat.typical_error = std::sqrt(squares / count);
      found.repeats.push_back(std::move(repeat));
    }
  }
}

/// The one that is furthest out goes first, as long as it is a contradiction: its neighbours are
/// off because of it.
void add_restitution_checks(const Observations& seen, Inspection& found) {
  for (std::size_t ball = 0; ball < seen.balls.size(); ++ball) {
    std::vector<const MeasuredImpact*> shots;
    for (const MeasuredImpact& shot : seen.shots)
      if (shot.ball == ball && shot.restitution.has_error()) shots.push_back(&shot);
    std::stable_sort(shots.begin(), shots.end(), [](const auto* a, const auto* b) {
      return a->impact.speed < b->impact.speed;
    });
    std::vector<DataCheck> checks = all_between_neighbours(shots);
    const double limit = contradiction_limit(found.checks.size() + checks.size());
    while (!checks.empty()) {
      const auto worst = std::max_element(
          checks.begin(), checks.end(), [](const DataCheck& a, const DataCheck& b) {
            return std::abs(a.deviations()) < std::abs(b.deviations());
          });
      if (!(std::abs(worst->deviations()) > limit)) break;
      found.checks.push_back(*worst);
      shots.erase(shots.begin() + (worst - checks.begin()) + 1);
      checks = all_between_neighbours(shots);
    }
    found.checks.insert(found.checks.end(), checks.begin(), checks.end());
  }
}

}  // namespace rebound
