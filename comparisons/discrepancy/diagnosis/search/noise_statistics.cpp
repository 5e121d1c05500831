#include "comparisons/discrepancy/diagnosis/search/noise_statistics.hpp"

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

#include "comparisons/inference/calibration/autocorrelation.hpp"
#include "comparisons/inference/calibration/distributions.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"

namespace rebound {

Eigen::MatrixXd coordinates_in_own_span(const Eigen::MatrixXd& units) {
  constexpr double left_out = 1e-8;  // of a unit column, in squares
  const Eigen::Index count = units.cols(), most = std::min(units.rows(), count);
  Eigen::MatrixXd products = Eigen::MatrixXd::Zero(count, count);
  products.selfadjointView<Eigen::Lower>().rankUpdate(units.transpose());
  products.triangularView<Eigen::StrictlyUpper>() = products.transpose();
  Eigen::VectorXd left = products.diagonal();
  Eigen::MatrixXd root(count, most);
  Eigen::Index rank = 0;
  for (Eigen::Index pivot = 0; rank < most; ++rank) {
    if (left.maxCoeff(&pivot) <= left_out) break;
    const double length = std::sqrt(left(pivot));
    Eigen::VectorXd column = products.col(pivot);
    column.noalias() -= root.leftCols(rank) * root.row(pivot).head(rank).transpose();
    root.col(rank) = column / length;
    left -= root.col(rank).cwiseAbs2();
    left(pivot) = 0.0;
  }
  return root.leftCols(rank);
}

double quantile_of_largest(const Eigen::MatrixXd& units, double level, std::uint64_t seed) {
  constexpr Eigen::Index draws = 4000, together = 250;
  if (units.cols() == 0) return 0.0;
  const Eigen::MatrixXd root = coordinates_in_own_span(units);
  boost::random::mt19937_64 generator(seed);
  boost::random::normal_distribution<double> normal;
  Eigen::MatrixXd noise(root.cols(), draws);
  for (double& value : noise.reshaped()) value = normal(generator);
  Eigen::VectorXd largest(draws);
  in_parallel(draws / together, [&](std::size_t block) {
    const Eigen::Index first = static_cast<Eigen::Index>(block) * together;
    largest.segment(first, together) =
        (root * noise.middleCols(first, together)).cwiseAbs().colwise().maxCoeff();
  });
  const auto place = static_cast<std::ptrdiff_t>((1.0 - level) * static_cast<double>(draws));
  std::nth_element(largest.begin(), largest.begin() + place, largest.end());
  return largest[place];
}

double noise_freedom_at(const Observations& seen, double angular_frequency) {
  if (!(seen.noise_freedom > 0.0)) return std::numeric_limits<double>::infinity();
  double largest = 0.0;  // power over the variance
  for (const MeasuredImpact& shot : seen.shots) {
    if (shot.noise.autocorrelation.empty()) continue;
    const LinearPredictors predictors = linear_predictors(shot.noise.autocorrelation);
    const std::vector<double>& a = predictors.coefficients.back();
    std::complex<double> left = 1.0;
    for (std::size_t k = 0; k < a.size(); ++k)
      left -= a[k] * std::polar(1.0, -static_cast<double>(k + 1) * angular_frequency);
    largest = std::max(largest, predictors.variance.back() / std::norm(left));
  }
  return seen.noise_freedom / (1.0 + 2.0 * largest);
}

double frequency_of(const Eigen::VectorXd& rows) {
  const Eigen::Index pairs = rows.size() - 1;
  const double square = rows.squaredNorm();
  if (pairs < 1 || !(square > 0.0)) return 0.0;
  return std::acos(std::clamp(rows.head(pairs).dot(rows.tail(pairs)) / square, -1.0, 1.0));
}

double limit_of_estimated_noise(double limit, double freedom) {
  if (!std::isfinite(freedom) || !(limit > 0.0)) return limit;
  return student_quantile(freedom, 1.0 - 0.5 * chi_squared_chance_above(1.0, limit * limit));
}

double square_of_known_noise(double square, double freedom) {
  if (!std::isfinite(freedom) || !(square > 0.0)) return square;
  constexpr double least = 1e-15;
  return chi_squared_quantile(1.0,
                              1.0 - std::max(least, fisher_chance_above(1.0, freedom, square)));
}

}  // namespace rebound
