#include "comparisons/models/instrument/butterworth.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "lumped/problem/error.hpp"

namespace rebound {

Butterworth::Butterworth(const Design& design) {
  const double ratio = design.corner / design.sampling_rate;
  if (!(ratio > 0.0 && ratio < 0.5))
    throw Error(ExitCode::bad_input, "the corner of a filter must lie below half the sampling rate",
                {.key = "bandwidth",
                 .value = std::to_string(design.corner) + " Hz",
                 .allowed = "(0, " + std::to_string(0.5 * design.sampling_rate) + " Hz)"});
  const double k = std::tan(std::numbers::pi * ratio);
  for (std::size_t i = 0; i < sections_.size(); ++i) {
    // Pole pairs at ±π/8 and ±3π/8 from the negative real axis: 1/Q = 2 cos.
    const double damping =
        2.0 * std::cos(std::numbers::pi / 8.0 * (2.0 * static_cast<double>(i) + 1.0));
    const double norm = 1.0 / (1.0 + damping * k + k * k);
    sections_[i] = {.b0 = k * k * norm,
                    .b1 = 2.0 * k * k * norm,
                    .b2 = k * k * norm,
                    .a1 = 2.0 * (k * k - 1.0) * norm,
                    .a2 = (1.0 - damping * k + k * k) * norm};
  }
}

std::vector<double> Butterworth::filter(const std::vector<double>& signal) const {
  std::vector<double> values = signal;
  for (const Section& s : sections_) {
    double one = 0.0, two = 0.0;  // transposed direct form II
    for (double& value : values) {
      const double out = s.b0 * value + one;
      one = s.b1 * value - s.a1 * out + two;
      two = s.b2 * value - s.a2 * out;
      value = out;
    }
  }
  return values;
}

}  // namespace rebound
