#include "comparisons/discrepancy/diagnosis/observations/quantisation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rebound {

double quantisation_step(const std::vector<double>& force) {
  std::vector<double> levels = force;
  std::sort(levels.begin(), levels.end());
  // A printed reading carries the rounding of its last digit.
  const double same = 1e-9 * std::max(std::abs(levels.front()), std::abs(levels.back()));
  const auto equal = [&](double a, double b) { return b - a <= same; };
  levels.erase(std::unique(levels.begin(), levels.end(), equal), levels.end());
  constexpr std::size_t fewest_levels = 3;
  constexpr double most_used_once = 0.8;  // of the readings
  if (levels.size() < fewest_levels ||
      static_cast<double>(levels.size()) > most_used_once * static_cast<double>(force.size()))
    return 0.0;
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < levels.size(); ++i) step = std::min(step, levels[i] - levels[i - 1]);
  // Two large readings are printed to fewer places than two small ones: the longer the way from the
  // first level, the better it tells the step.
  for (const double level : levels)
    if (const double count = std::round((level - levels.front()) / step); count > 0.0)
      step = (level - levels.front()) / count;
  constexpr double forgiven = 1e-3;  // of a step
  for (const double level : levels) {
    const double count = (level - levels.front()) / step;
    if (std::abs(count - std::round(count)) > forgiven) return 0.0;
  }
  return step;
}

double quantisation_noise(double step) {
  return step / std::sqrt(12.0);
}

}  // namespace rebound
