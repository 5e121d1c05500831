#include "comparisons/inference/calibration/whitening.hpp"

#include <algorithm>
#include <cmath>

namespace rebound {

void take_out_shared_error(const ForceNoise& noise, std::span<double> rows, std::size_t width) {
  if (noise.shared == 0.0) return;
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

std::vector<double> whitened(const MeasuredImpact& measured, const std::vector<double>& model) {
  std::vector<double> r(model.size());
  for (std::size_t i = 0; i < r.size(); ++i)
    r[i] = (model[i] - measured.trace.force[i]) / measured.noise.deviation;
  take_out_shared_error(measured.noise, r);
  return r;
}

}  // namespace rebound
