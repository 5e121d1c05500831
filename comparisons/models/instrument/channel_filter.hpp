#pragma once

#include <array>
#include <vector>

namespace rebound {

/// Channel frequency classes of SAE J211 [Hz].
inline constexpr std::array<double, 4> channel_classes{60.0, 180.0, 600.0, 1000.0};

/// The −3 dB frequency of a class: 1.667 times its number; J211 states 100, 300, 1000, 1650 Hz.
double class_corner(double channel_class);

/// Phaseless Butterworth filter of SAE J211, Appendix C: two poles forwards and the same two
/// backwards.
///
///   ω_d = 2π · 2.0775 · CFC,   ω_a = tan(ω_d T/2),   D = 1 + √2 ω_a + ω_a²
///   a₀ = ω_a²/D, a₁ = 2 a₀, a₂ = a₀, b₁ = −2 (ω_a² − 1)/D, b₂ = (−1 + √2 ω_a − ω_a²)/D
///   y_n = a₀ x_n + a₁ x_(n−1) + a₂ x_(n−2) + b₁ y_(n−1) + b₂ y_(n−2)
///
/// The ends are continued by their mean over ten samples, so that an offset starts nothing.
///
/// Valid:   sampling at ten times the class or more, as J211 asks; equally spaced samples.
/// Limit:   gain 1 at rest; 1/√2 at class_corner, forwards and backwards together; no delay
///          -> test ChannelFilterTest.
/// Errors:  Error(bad_input) for a sampling rate below ten times the class.
/// Source:  SAE J211-1, Appendix C.
std::vector<double> channel_filtered(const std::vector<double>& signal, double interval,
                                     double channel_class);

}  // namespace rebound
