#pragma once

#include <span>
#include <vector>

/// Noise whose neighbouring samples are alike.
namespace rebound {

/// Best linear predictors of a stationary series from its own past, of every order up to p.
///
///   x̂_i = Σ_k a_k^(m) x_(i−k),  k = 1…m      v_m = E (x_i − x̂_i)² / E x_i²,  v_0 = 1
///
/// Source: Levinson–Durbin recursion, e.g. Brockwell & Davis, Time Series: Theory and Methods,
///         1991, section 5.2.
struct LinearPredictors {
  std::vector<std::vector<double>> coefficients;  ///< [m][k − 1], m = 0…p
  std::vector<double> variance;                   ///< v_m
};

/// From the autocorrelation at lags 1…p, ρ_0 = 1 left out.
LinearPredictors linear_predictors(const std::vector<double>& autocorrelation);

/// What samples without a signal say of the noise.
struct EstimatedNoise {
  double deviation = 0.0;  ///< of one sample; 0: too few samples
  int samples = 0;
  /// Of the autoregressive model that describes them, at its lags; empty: white.
  std::vector<double> autocorrelation;
};

/// Standard deviation and colour of noise from stretches of it, one straight line taken out of
/// them all: an offset and a drift from the start of the records are faults of their own, and no
/// noise.
///
/// Scheme: Burg's recursion over all stretches, which has no bias where they are short. The order p
///         of the autoregressive model has the least n ln v_p + p ln n. The autocorrelation is cut
///         by 1e-4, as if as much white noise were beside it: noise without any power at high
///         frequencies would make a model's own rounding there decide a fit.
/// Source: Burg 1975, Maximum Entropy Spectral Analysis; de Waele & Broersen, IEEE Trans. Signal
///         Processing 48 (2000) 2876 for segments.
///
/// Valid:   stationary noise, stretches of ten samples or more.
/// Limit:   white noise is called white in nine of ten cases and more
///          -> test AutocorrelationTest.WhiteNoiseIsWhite; an autoregressive series gives its
///          coefficients -> test AutocorrelationTest.FindsAnAutoregressiveSeries.
EstimatedNoise estimate_noise(const std::vector<std::span<const double>>& stretches);

/// Autocorrelation at lags 1 to `lags`, beyond those given as their autoregressive model goes on.
///
///   ρ_l = Σ_k a_k ρ_(l−k)
std::vector<double> continued(std::vector<double> autocorrelation, std::size_t lags);

/// How many independent samples tell as much of a constant as one sample of this noise.
///
///   (1 − Σ a_k)²/v_p
double effective_share(const std::vector<double>& autocorrelation);

/// The same for its variance: 1/Σ ρ_k² over all lags, both signs.
double effective_share_of_variance(const std::vector<double>& autocorrelation);

}  // namespace rebound
