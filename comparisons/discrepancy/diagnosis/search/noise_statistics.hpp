#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "comparisons/inference/calibration/observations.hpp"

namespace rebound {

/// Rows q_j with q_i · q_j = u_i · u_j, in as few numbers as the columns span: Cholesky's factor of
/// their products by largest pivots.
/// Limit: columns of which one is a sum of the others need one number less
///        -> test NoiseStatisticsTest.ProductsAreThoseOfTheColumns.
Eigen::MatrixXd coordinates_in_own_span(const Eigen::MatrixXd& units);

/// What the largest of several linear statistics of white noise exceeds by chance.
///
///   P( max_j |u_j · ε| > q ) = level,   ε ~ N(0, I)
///
///   units   columns u_j, of length one or zero [rows][statistics]
///
/// From 4000 seeded draws in the space the columns span.
/// Limit: one column gives the two-sided normal quantile
///        -> test NoiseStatisticsTest.OneStatisticIsNormal.
double quantile_of_largest(const Eigen::MatrixXd& units, double level, std::uint64_t seed);

/// How well the samples before contact tell the noise at a frequency: freedom ν of its power, as an
/// estimate that is χ²_ν distributed.
///
///   ν = N/(1 + 2 S(ω)/γ₀),   S/γ₀ = (1 − Σ a_k ρ_k)/|1 − Σ a_k exp(−i k ω)|²
///
///   ω   radians per sample     a_k, ρ_k   coefficients and autocorrelation of the noise
///   S   its spectrum, of mean γ₀, the variance
///
/// N samples tell the power of white noise to √(2/N). That of a series of order one with
/// coefficient a is known at zero to 2/N + 4 (1 + a)/((1 − a) N), for a is estimated, too: what is
/// slow passes for an effect where the quiet is short.
///
/// Valid:  series of order one; of higher orders, about.
/// Limit:  infinite where the noise is known; N where it is white
///         -> test NoiseStatisticsTest.SlowNoiseIsKnownFromFewerSamples.
/// Source: G. E. P. Box & G. M. Jenkins, Time Series Analysis (1970): the variance of an
///         autoregressive coefficient is (1 − a²)/N.
double noise_freedom_at(const Observations& seen, double angular_frequency);

/// A frequency at which most of a column of whitened rows lies, from how alike neighbours are
/// [rad].
double frequency_of(const Eigen::VectorXd& rows);

/// What |u · ε| must exceed where the noise is estimated with ν degrees of freedom, for the chance
/// with which it exceeds `limit` where the noise is known: a quantile of Student's t.
/// Limit: ν → ∞ gives `limit` -> test NoiseStatisticsTest.SlowNoiseIsKnownFromFewerSamples.
double limit_of_estimated_noise(double limit, double freedom);

/// The other way round, of squares: what is as unlikely where the noise is known, 64 at most.
double square_of_known_noise(double square, double freedom);

}  // namespace rebound
