#include "comparisons/inference/calibration/whitening.hpp"

#include <algorithm>
#include <cmath>

#include "comparisons/inference/calibration/autocorrelation.hpp"

namespace rebound {

namespace {

/// Last rows first: each still finds its neighbours as they were.
void take_out_neighbours(const std::vector<double>& autocorrelation, std::span<double> rows,
                         std::size_t width) {
  const LinearPredictors predictors = linear_predictors(autocorrelation);
  const std::size_t order = autocorrelation.size();
  for (std::size_t i = rows.size() / width; i-- > 0;) {
    const std::size_t known = std::min(i, order);
    const std::vector<double>& coefficients = predictors.coefficients[known];
    const double deviation = std::sqrt(predictors.variance[known]);
    for (std::size_t j = 0; j < width; ++j) {
      double left = rows[i * width + j];
      for (std::size_t k = 1; k <= known; ++k)
        left -= coefficients[k - 1] * rows[(i - k) * width + j];
      rows[i * width + j] = left / deviation;
    }
  }
}

void take_out_shared_error(const ForceNoise& noise, std::span<double> rows, std::size_t width) {
  const double ratio = noise.shared / noise.deviation;
  const std::size_t samples = rows.size() / width;
  for (std::size_t first = 0; first < samples; first += noise.shared_by) {
    const std::size_t last = std::min(first + noise.shared_by, samples);
    const auto count = static_cast<double>(last - first);
    for (std::size_t j = 0; j < width; ++j) {
      double mean = 0.0;
      for (std::size_t i = first; i < last; ++i) mean += rows[i * width + j] / count;
      const double taken = mean * (1.0 - 1.0 / std::sqrt(1.0 + count * ratio * ratio));
      for (std::size_t i = first; i < last; ++i) rows[i * width + j] -= taken;
    }
  }
}

}  // namespace

void take_out_correlation(const ForceNoise& noise, std::span<double> rows, std::size_t width) {
  if (!noise.autocorrelation.empty()) take_out_neighbours(noise.autocorrelation, rows, width);
  if (noise.shared != 0.0) take_out_shared_error(noise, rows, width);
}

std::vector<double> whitened(const MeasuredImpact& measured, const std::vector<double>& model) {
  std::vector<double> r(model.size());
  for (std::size_t i = 0; i < r.size(); ++i)
    r[i] = (model[i] - measured.trace.force[i]) / measured.noise.deviation;
  take_out_correlation(measured.noise, r);
  return r;
}

std::vector<double> whitened_deflections(const MeasuredImpact& measured, const SampleRange& range,
                                         const std::vector<double>& model) {
  std::vector<double> r(model.size());
  for (std::size_t i = 0; i < r.size(); ++i)
    r[i] = (model[i] - measured.trace.deflection[range.first + i]) /
           measured.deflection_noise.deviation;
  take_out_correlation(measured.deflection_noise, r);
  return r;
}

}  // namespace rebound
