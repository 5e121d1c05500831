#include "comparisons/discrepancy/diagnosis/asked_fem/first_order_gain.hpp"

#include <algorithm>
#include <utility>

namespace rebound {

BesideFittedNumbers::BesideFittedNumbers(Eigen::VectorXd residuals, const Eigen::MatrixXd& slopes)
    : residuals_(std::move(residuals)) {
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(slopes);
  reached_ = qr.householderQ() * Eigen::MatrixXd::Identity(slopes.rows(), qr.rank());
}

BesideFittedNumbers::Sums BesideFittedNumbers::sums_of(const Eigen::VectorXd& change) const {
  constexpr double nearly_nothing = 1e-4;  // of its square: ripple of nodes that touch one by one
  const Eigen::VectorXd missing = left(change);
  if (missing.squaredNorm() <= nearly_nothing * change.squaredNorm()) return {};
  return {.along = residuals_.dot(missing), .square = missing.squaredNorm()};
}

Eigen::VectorXd BesideFittedNumbers::left(const Eigen::VectorXd& residuals) const {
  return residuals - reached_ * (reached_.transpose() * residuals);
}

BesideFittedNumbers::Sums& BesideFittedNumbers::Sums::operator+=(const Sums& other) {
  along += other.along;
  square += other.square;
  return *this;
}

FirstOrderGain BesideFittedNumbers::Sums::gain() const {
  if (!(square > 0.0)) return {};
  return {.chi_square = along * along / square, .factor = -along / square};
}

FirstOrderGain BesideFittedNumbers::Sums::gain_as_it_stands() const {
  return {.chi_square = std::max(0.0, -2.0 * along - square), .factor = 1.0};
}

}  // namespace rebound
