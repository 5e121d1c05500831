#include "comparisons/discrepancy/design/chance_found.hpp"

#include <algorithm>
#include <cmath>

#include "comparisons/inference/calibration/distributions.hpp"

namespace rebound {

double chance_found(double rise, double threshold, double false_gap_level) {
  return std::max(false_gap_level, normal_chance_below(std::sqrt(rise) - std::sqrt(threshold)));
}

double rise_of_chance(double chance, double threshold) {
  const double root = std::sqrt(threshold) + normal_quantile(chance);
  return root > 0.0 ? root * root : 0.0;
}

}  // namespace rebound
