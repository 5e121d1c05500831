#include "comparisons/discrepancy/diagnosis/observations/numerical_error.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "comparisons/inference/calibration/autocorrelation.hpp"

namespace rebound {

void add_numerical_error(MeasuredImpact& shot, double error) {
  constexpr std::size_t blocks =
      8;  // of a history: about six in a contact, as many as it has phases
  // An autoregressive series with white noise beside it has more lags than by itself.
  constexpr std::size_t lags = 32;
  const double of_data = shot.noise.deviation;
  shot.noise.deviation = std::hypot(of_data, error);
  std::vector<double>& colour = shot.noise.autocorrelation;
  if (!colour.empty() && error > 0.0) {
    colour = continued(std::move(colour), lags);
    const double share = of_data / shot.noise.deviation;
    for (double& at_lag : colour) at_lag *= share * share;
  }
  shot.noise.shared = error;
  shot.noise.shared_by = std::max<std::size_t>(1, shot.trace.force.size() / blocks);
}

}  // namespace rebound
