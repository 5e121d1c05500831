#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace rebound {

/// Rows q_j with q_i · q_j = u_i · u_j, in as few numbers as the columns span: Cholesky's factor of
/// their products by largest pivots, which needs the products with the pivots alone.
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

}  // namespace rebound
