#include "comparisons/discrepancy/design/rise_of_chance.hpp"

#include <cmath>

#include "comparisons/inference/calibration/distributions.hpp"

namespace rebound {

double rise_of_chance(double chance, double threshold) {
  const double root = std::sqrt(threshold) + normal_quantile(chance);
  return root > 0.0 ? root * root : 0.0;
}

}  // namespace rebound
