#include "comparisons/discrepancy/diagnosis/noise_statistics.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <vector>

namespace rebound {

double quantile_of_largest(const Eigen::MatrixXd& units, double level, std::uint64_t seed) {
  constexpr int draws = 4000;
  if (units.cols() == 0) return 0.0;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> spectrum(units.transpose() * units);
  const Eigen::MatrixXd root =
      spectrum.eigenvectors() * spectrum.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
  boost::random::mt19937_64 generator(seed);
  boost::random::normal_distribution<double> normal;
  std::vector<double> largest;
  Eigen::VectorXd noise(units.cols());
  for (int k = 0; k < draws; ++k) {
    for (double& value : noise) value = normal(generator);
    largest.push_back((root * noise).cwiseAbs().maxCoeff());
  }
  const auto place = static_cast<std::ptrdiff_t>((1.0 - level) * draws);
  std::nth_element(largest.begin(), largest.begin() + place, largest.end());
  return largest[static_cast<std::size_t>(place)];
}

}  // namespace rebound
