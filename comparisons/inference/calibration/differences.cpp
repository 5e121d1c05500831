#include "comparisons/inference/calibration/differences.hpp"

#include <algorithm>
#include <optional>

#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// Nothing where an impact does not end.
std::optional<std::vector<double>> on_one_side(const ResidualFunction& residuals,
                                               const std::vector<double>& x) {
  try {
    return residuals(x);
  } catch (const Error& error) {
    if (error.code() != ExitCode::solver_failed) throw;
    return std::nullopt;
  }
}

}  // namespace

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
    const auto high = on_one_side(residuals, at);
    at[j] = below;
    const auto low = high ? on_one_side(residuals, at) : std::optional(residuals(at));
    at[j] = x[j];
    const std::vector<double>& upper = high ? *high : found.residuals;
    const std::vector<double>& lower = low ? *low : found.residuals;
    const double step_taken = (high ? above : x[j]) - (low ? below : x[j]);
    if (!(step_taken > 0.0))
      throw Error(ExitCode::solver_failed, "no impact ends on the one side of '" + parameter.name +
                                               "' that its bound leaves");
    for (std::size_t i = 0; i < upper.size(); ++i)
      found.slopes[i * unknowns + j] = (upper[i] - lower[i]) / step_taken;
  }
  return found;
}

}  // namespace rebound
