#pragma once

#include <array>
#include <vector>

namespace rebound {

/// Causal low-pass filter with four poles, maximally flat.
///
///   |H(f)|² = 1 / (1 + (f/f_c)⁸),   f_c = −3 dB
///
/// Two second-order sections by the bilinear transform with the corner
/// prewarped, started at rest.
///
/// Valid:   f_c below half the sampling rate; at f_c above a tenth of it the
///          response is that of the transform rather than of the formula.
/// Limit:   gain 1 at rest and 1/√2 at f_c -> test ButterworthTest.HalfPowerAtTheCorner.
/// Errors:  Error(bad_input) for a corner outside (0, half the sampling rate).
/// Source:  Butterworth 1930; bilinear transform as in any text on digital filters.
class Butterworth {
 public:
  struct Design {
    double corner = 0.0;         ///< [Hz]
    double sampling_rate = 0.0;  ///< [Hz]
  };
  explicit Butterworth(const Design& design);

  std::vector<double> filter(const std::vector<double>& signal) const;

 private:
  struct Section {
    double b0, b1, b2, a1, a2;
  };
  std::array<Section, 2> sections_;
};

}  // namespace rebound
