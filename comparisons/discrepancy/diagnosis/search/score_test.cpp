#include "comparisons/discrepancy/diagnosis/search/score_test.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "comparisons/inference/calibration/distributions.hpp"

namespace rebound {

ScoreTest least_likely(const std::vector<ScoreTest>& outcomes) {
  ScoreTest least = *std::min_element(
      outcomes.begin(), outcomes.end(),
      [](const ScoreTest& a, const ScoreTest& b) { return a.p_value < b.p_value; });
  least.p_value = std::min(1.0, static_cast<double>(outcomes.size()) * least.p_value);
  return least;
}

void ScoredColumns::add(const Eigen::VectorXd& column) {
  constexpr double absorbed = 0.05;  // what is left of a unit column
  if (!(column.norm() > 0.0)) return;
  const Eigen::VectorXd left = around_.project(column.normalized());
  if (left.norm() > absorbed) kept_.push_back(left.normalized());
}

ScoreTest ScoredColumns::tested_on(const std::vector<double>& residuals,
                                   double noise_freedom) const {
  if (kept_.empty()) return {};
  constexpr double dependent = 1e-2;
  Eigen::MatrixXd all(kept_.front().size(), std::ssize(kept_));
  for (Eigen::Index j = 0; j < all.cols(); ++j) all.col(j) = kept_[static_cast<std::size_t>(j)];
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr;
  qr.setThreshold(dependent);
  qr.compute(all);
  Eigen::VectorXd turned = Eigen::Map<const Eigen::VectorXd>(residuals.data(), all.rows());
  turned.applyOnTheLeft(qr.householderQ().transpose());
  ScoreTest test{.chi_square = turned.head(qr.rank()).squaredNorm(),
                 .freedom = static_cast<int>(qr.rank())};
  test.p_value =
      std::isfinite(noise_freedom)
          ? fisher_chance_above(test.freedom, noise_freedom, test.chi_square / test.freedom)
          : chi_squared_chance_above(test.freedom, test.chi_square);
  return test;
}

}  // namespace rebound
