#include "comparisons/inference/calibration/differences.hpp"

#include <algorithm>

namespace rebound {

ResidualsWithJacobian with_differences(const std::vector<CalibrationParameter>& parameters,
                                       const ResidualFunction& residuals,
                                       const std::vector<double>& x, double step) {
  ResidualsWithJacobian found{.residuals = residuals(x), .slopes = {}};
  const std::size_t unknowns = x.size();
  found.slopes.resize(found.residuals.size() * unknowns);
  std::vector<double> at = x;
  for (std::size_t j = 0; j < unknowns; ++j) {
    const CalibrationParameter& parameter = parameters[j];
    const double above = std::min(x[j] + step * parameter.scale, parameter.highest);
    const double below = std::max(x[j] - step * parameter.scale, parameter.lowest);
    at[j] = above;
    const std::vector<double> high = residuals(at);
    at[j] = below;
    const std::vector<double> low = residuals(at);
    at[j] = x[j];
    for (std::size_t i = 0; i < high.size(); ++i)
      found.slopes[i * unknowns + j] = (high[i] - low[i]) / (above - below);
  }
  return found;
}

}  // namespace rebound
