#include "comparisons/discrepancy/diagnosis/observations/repeated_shots.hpp"

#include <cmath>

namespace rebound {
namespace {

constexpr double near = 0.02;  // of a speed
constexpr std::size_t fewest = 3;

bool share(const MeasuredImpact& a, const MeasuredImpact& b) {
  return a.ball == b.ball && a.sphere == b.sphere && a.impact.separation == b.impact.separation &&
         std::abs(a.impact.speed / b.impact.speed - 1.0) <= near;
}

std::vector<double> between(const std::vector<double>& a, const std::vector<double>& b,
                            double share) {
  std::vector<double> column(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) column[i] = a[i] + share * (b[i] - a[i]);
  return column;
}

}  // namespace

std::vector<std::size_t> shots_that_share(const Observations& seen, const LumpedModel& believed) {
  const std::size_t count = seen.shots.size();
  std::vector<std::size_t> first(count);
  for (std::size_t i = 0; i < count; ++i) first[i] = i;
  // Numbers that belong to a shot, or follow from its own restitution, are no function of speed.
  if (!believed.at_speed.empty() || !believed.damping_formula.empty()) return first;
  for (std::size_t i = 0; i < count; ++i) {
    if (first[i] != i) continue;
    std::vector<std::size_t> group;
    for (std::size_t j = i; j < count; ++j)
      if (first[j] == j && share(seen.shots[j], seen.shots[i])) group.push_back(j);
    if (group.size() < fewest) continue;
    for (const std::size_t j : group) first[j] = i;
  }
  return first;
}

ModelledImpact between(const ModelledImpact& a, const ModelledImpact& b, double share) {
  ModelledImpact result = a;
  result.trace.time = between(a.trace.time, b.trace.time, share);
  result.trace.force = between(a.trace.force, b.trace.force, share);
  result.trace.deflection = between(a.trace.deflection, b.trace.deflection, share);
  for (std::size_t k = 0; k < a.trace.further.size(); ++k)
    result.trace.further[k].values =
        between(a.trace.further[k].values, b.trace.further[k].values, share);
  for (const auto scalar : {&ImpactScalars::restitution, &ImpactScalars::contact_time,
                            &ImpactScalars::contact_time_1pct, &ImpactScalars::peak_force,
                            &ImpactScalars::peak_deflection, &ImpactScalars::mean_deflection,
                            &ImpactScalars::rebound_speed})
    result.scalars.*scalar += share * (b.scalars.*scalar - a.scalars.*scalar);
  return result;
}

}  // namespace rebound
