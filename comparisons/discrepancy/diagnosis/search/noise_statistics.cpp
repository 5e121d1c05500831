#include "comparisons/discrepancy/diagnosis/search/noise_statistics.hpp"

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <cmath>
#include <vector>

namespace rebound {

Eigen::MatrixXd coordinates_in_own_span(const Eigen::MatrixXd& units) {
  constexpr double left_out = 1e-8;  // of a unit column, in squares
  const Eigen::Index count = units.cols(), most = std::min(units.rows(), count);
  Eigen::VectorXd left = units.colwise().squaredNorm();
  Eigen::MatrixXd root(count, most);
  Eigen::Index rank = 0;
  for (Eigen::Index pivot = 0; rank < most; ++rank) {
    if (left.maxCoeff(&pivot) <= left_out) break;
    const double length = std::sqrt(left(pivot));
    Eigen::VectorXd column = units.transpose() * units.col(pivot);
    column.noalias() -= root.leftCols(rank) * root.row(pivot).head(rank).transpose();
    root.col(rank) = column / length;
    left -= root.col(rank).cwiseAbs2();
    left(pivot) = 0.0;
  }
  return root.leftCols(rank);
}

double quantile_of_largest(const Eigen::MatrixXd& units, double level, std::uint64_t seed) {
  constexpr int draws = 4000, together = 250;
  if (units.cols() == 0) return 0.0;
  const Eigen::MatrixXd root = coordinates_in_own_span(units);
  boost::random::mt19937_64 generator(seed);
  boost::random::normal_distribution<double> normal;
  std::vector<double> largest;
  Eigen::MatrixXd noise(root.cols(), together), statistics(root.rows(), together);
  while (std::ssize(largest) < draws) {
    for (double& value : noise.reshaped()) value = normal(generator);
    statistics.noalias() = root * noise;
    for (Eigen::Index k = 0; k < together; ++k)
      largest.push_back(statistics.col(k).cwiseAbs().maxCoeff());
  }
  const auto place = static_cast<std::ptrdiff_t>((1.0 - level) * draws);
  std::nth_element(largest.begin(), largest.begin() + place, largest.end());
  return largest[static_cast<std::size_t>(place)];
}

}  // namespace rebound
