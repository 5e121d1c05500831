#include "comparisons/discrepancy/diagnosis/believed_fem/carried_difference.hpp"

#include <algorithm>
#include <cmath>

#include "comparisons/models/instrument/reported_force.hpp"

namespace rebound {
namespace {

double largest_of(const std::vector<double>& column) {
  return *std::max_element(column.begin(), column.end());
}

/// (b − a) over the largest of a, phase by phase.
std::vector<double> share_added(const std::vector<double>& a, const std::vector<double>& b) {
  const double peak = largest_of(a);
  std::vector<double> added(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) added[i] = (b[i] - a[i]) / peak;
  return added;
}

void add_share(const std::vector<double>& added, double share, std::vector<double>& column) {
  const double scale = share * largest_of(column);
  for (std::size_t i = 0; i < column.size(); ++i) column[i] += scale * added[i];
}

struct ScalarRatio {
  double ImpactScalars::*scalar;
  double CarriedDifference::*ratio;
};
constexpr ScalarRatio ratios[] = {
    {&ImpactScalars::restitution, &CarriedDifference::restitution},
    {&ImpactScalars::rebound_speed, &CarriedDifference::rebound_speed},
    {&ImpactScalars::contact_time, &CarriedDifference::contact_time},
    {&ImpactScalars::contact_time_1pct, &CarriedDifference::contact_time_1pct},
    {&ImpactScalars::peak_force, &CarriedDifference::peak_force},
    {&ImpactScalars::peak_deflection, &CarriedDifference::peak_deflection},
    {&ImpactScalars::mean_deflection, &CarriedDifference::mean_deflection}};

}  // namespace

CarriedDifference difference_between(const ModelledImpact& first, const ModelledImpact& second) {
  CarriedDifference difference;
  difference.force = share_added(first.trace.force, second.trace.force);
  difference.deflection = share_added(first.trace.deflection, second.trace.deflection);
  difference.duration = second.trace.time.back() / first.trace.time.back();
  for (const auto& [scalar, ratio] : ratios)
    difference.*ratio = second.scalars.*scalar / first.scalars.*scalar;
  return difference;
}

void CarriedDifference::apply(ModelledImpact& impact) const {
  apply_times(impact, 1.0);
}

void CarriedDifference::apply_times(ModelledImpact& impact, double times) const {
  add_share(force, times, impact.trace.force);
  add_share(deflection, times, impact.trace.deflection);
  const double longer = std::pow(duration, times);
  for (double& time : impact.trace.time) time *= longer;
  for (const auto& [scalar, ratio] : ratios)
    impact.scalars.*scalar *= std::pow(this->*ratio, times);
}

void KnownDifferences::carry_to(ModelledImpact& impact, double other_speed) const {
  if (other_speed != speed)
    faster.apply_times(impact, std::log(other_speed / speed) / std::log1p(step));
}

double history_difference(const ModelledImpact& a, const ModelledImpact& b) {
  const std::vector<double> other = reported_force(b.trace, {}, a.trace.time);
  double sum = 0.0;
  for (std::size_t i = 0; i < other.size(); ++i) sum += std::pow(other[i] - a.trace.force[i], 2);
  return std::sqrt(sum / static_cast<double>(other.size())) / largest_of(a.trace.force);
}

}  // namespace rebound
