#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace rebound {

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

}  // namespace rebound
