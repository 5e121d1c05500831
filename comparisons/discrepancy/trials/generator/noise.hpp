#pragma once

#include <string>
#include <vector>

#include "comparisons/discrepancy/trials/generator/random.hpp"

namespace trials {

enum class NoiseColour { white, autoregressive, band_limited, one_over_f };
std::string name_of(NoiseColour colour);

/// Noise of one trial.
struct Noise {
  NoiseColour colour = NoiseColour::white;
  /// Correlation of neighbours (autoregressive), or cut-off over sampling rate (band-limited).
  double parameter = 0.0;
  double fraction = 0.0;   ///< deviation over the smallest peak force of the baseline's shots
  double deviation = 0.0;  ///< of one sample [N]
};

/// Correlation of samples `lag` apart:   φ^k,   p^k (1 + k (1 − p²)/(1 + p²)) with both poles at p,
/// and the mean of the eight.
double autocorrelation(const Noise& noise, std::size_t lag);

/// Stationary noise of that deviation.
///
///   autoregressive   n_i = φ n_{i−1} + √(1 − φ²) w_i
///   band-limited     white noise through two equal poles
///   1/f              equal parts of eight autoregressive ones, times an octave and a half apart
std::vector<double> draw_noise(const Noise& noise, int count, Random& random);

}  // namespace trials
