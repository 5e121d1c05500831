#include "comparisons/discrepancy/diagnosis/observations/zero_offset.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rebound {
namespace {

using Force = std::vector<double>;

double mean_of(Force::const_iterator begin, Force::const_iterator end) {
  return std::accumulate(begin, end, 0.0) / static_cast<double>(end - begin);
}

double rise_of(const Force& force, double level) {
  return *std::max_element(force.begin(), force.end()) - level;
}

bool is_gross(const Force& force, double level) {
  constexpr double share = 0.05;
  return std::abs(level) > share * rise_of(force, level);
}

}  // namespace

double level_of(const std::vector<double>& force) {
  constexpr std::ptrdiff_t fewest = 8, parts = 20;
  const std::ptrdiff_t block = std::max(fewest, std::ssize(force) / parts);
  if (std::ssize(force) < 4 * block) return 0.0;
  constexpr double flat = 0.05;
  const double before = mean_of(force.begin(), force.begin() + block);
  const double after = mean_of(force.end() - block, force.end());
  const double rise = rise_of(force, before);
  const auto is_flat = [&](Force::const_iterator begin) {
    const auto middle = begin + block / 2;
    return std::abs(mean_of(begin, middle) - mean_of(middle, begin + block)) <= flat * rise;
  };
  const bool is_level = is_flat(force.begin()) && is_flat(force.end() - block) &&
                        std::abs(before - after) <= flat * rise;
  return is_level ? before : 0.0;
}

double take_out_zero_offset(std::span<MeasuredImpact> shots) {
  const bool any = std::any_of(shots.begin(), shots.end(), [](const MeasuredImpact& shot) {
    return shot.has_history() && is_gross(shot.trace.force, level_of(shot.trace.force));
  });
  double largest = 0.0;
  if (!any) return largest;
  for (MeasuredImpact& shot : shots) {
    const double level = level_of(shot.trace.force);
    for (double& force : shot.trace.force) force -= level;
    if (std::abs(level) > std::abs(largest)) largest = level;
  }
  return largest;
}

}  // namespace rebound
