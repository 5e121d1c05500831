#include "comparisons/discrepancy/diagnosis/output/residual_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/inference/calibration/whitening.hpp"

namespace rebound {
namespace {

report::Series residual_series(const std::string& name, report::Origin origin,
                               const GatheredResiduals& residuals) {
  return {.name = name,
          .origin = origin,
          .x = report::scaled(residuals.time, report::milli),
          .y = residuals.z};
}

/// Nineteen in twenty where nothing is missing.
report::Series noise_band(const std::vector<double>& time) {
  constexpr double reach = 1.96;
  return {.name = "noise",
          .origin = report::Origin::derived,
          .role = report::Series::Role::reference,
          .x = report::scaled(time, report::milli),
          .y = std::vector<double>(time.size(), 0.0),
          .y_low = std::vector<double>(time.size(), -reach),
          .y_high = std::vector<double>(time.size(), reach)};
}

}  // namespace

GatheredResiduals gathered_residuals(const MeasuredImpact& measured,
                                     const std::vector<double>& model, std::size_t points) {
  const std::vector<double> residuals = whitened(measured, model);
  const std::size_t size = std::max<std::size_t>(1, residuals.size() / points);
  GatheredResiduals gathered;
  for (std::size_t i = 0; i + size <= residuals.size(); i += size) {
    double sum = 0.0;
    for (std::size_t k = i; k < i + size; ++k) sum += residuals[k];
    const std::vector<double>& time = measured.trace.time;
    gathered.time.push_back(0.5 * (time[i] + time[i + size - 1]));
    gathered.z.push_back(sum / std::sqrt(static_cast<double>(size)));
  }
  return gathered;
}

report::Figure residual_figure(const MeasuredImpact& measured, const std::vector<double>& before,
                               const std::vector<double>* after, report::Origin origin) {
  const GatheredResiduals gathered = gathered_residuals(measured, before);
  report::Figure figure{
      .title = "Residuals: " + measured.label,
      .caption =
          "Model minus data, whitened, neighbouring samples together. The noise alone "
          "stays within the band nineteen times in twenty.",
      .x = {"time", "ms"},
      .y = {"residual", "σ"},
      .series = {noise_band(gathered.time), residual_series(before_name, origin, gathered)}};
  if (after)
    figure.series.push_back(
        residual_series(after_name, origin, gathered_residuals(measured, *after)));
  return figure;
}

}  // namespace rebound
