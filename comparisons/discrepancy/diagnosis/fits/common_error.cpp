#include "comparisons/discrepancy/diagnosis/fits/common_error.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "comparisons/inference/calibration/whitening.hpp"
#include "comparisons/io/dataset/contact_window.hpp"

namespace rebound {
namespace {

constexpr std::size_t parts = 8;

/// Weight of the k-th eighth of a contact at a phase of it: 1 at its middle, 0 at its neighbours'.
double weight_at(double phase, std::size_t k) {
  const double place = std::clamp(phase * parts - 0.5, 0.0, static_cast<double>(parts - 1));
  return std::max(0.0, 1.0 - std::abs(place - static_cast<double>(k)));
}

/// Whitened force of each error in one shot: a row a sample.
Eigen::MatrixXd errors_in(const MeasuredImpact& shot) {
  const std::vector<double>& force = shot.trace.force;
  const double peak = *std::max_element(force.begin(), force.end());
  const SampleRange contact = contact_window(force, clearly_in_contact * peak);
  const auto samples = static_cast<Eigen::Index>(force.size());
  Eigen::MatrixXd errors = Eigen::MatrixXd::Zero(samples, parts);
  const double size = shot.noise.shared / shot.noise.deviation;
  for (std::size_t k = 0; k < parts; ++k) {
    std::vector<double> column(force.size(), 0.0);
    for (std::size_t i = contact.first; i <= contact.last; ++i)
      column[i] = size * weight_at(static_cast<double>(i - contact.first) /
                                       static_cast<double>(contact.count()),
                                   k);
    take_out_correlation(shot.noise, column);
    errors.col(static_cast<Eigen::Index>(k)) =
        Eigen::Map<const Eigen::VectorXd>(column.data(), samples);
  }
  return errors;
}

}  // namespace

CommonError::CommonError(const Observations& seen, const std::vector<std::size_t>& force_rows,
                         std::size_t rows) {
  for (std::size_t ball = 0; ball < seen.balls.size(); ++ball) {
    Eigen::MatrixXd errors;
    for (std::size_t i = 0; i < seen.shots.size(); ++i) {
      const MeasuredImpact& shot = seen.shots[i];
      if (shot.ball != ball || !shot.has_history() || shot.noise.shared <= 0.0) continue;
      if (errors.size() == 0) errors.setZero(static_cast<Eigen::Index>(rows), parts);
      errors.middleRows(static_cast<Eigen::Index>(force_rows[i]),
                        static_cast<Eigen::Index>(shot.trace.force.size())) = errors_in(shot);
    }
    if (errors.size() == 0) continue;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> of(errors.transpose() * errors);
    const Eigen::VectorXd sizes = of.eigenvalues().cwiseMax(0.0);
    constexpr double nothing = 1e-12;
    const Eigen::VectorXd inverse_roots =
        (sizes.array() > nothing).select(sizes.array().rsqrt(), 0.0);
    balls_.push_back({.directions = errors * of.eigenvectors() * inverse_roots.asDiagonal(),
                      .taken = 1.0 - (1.0 + sizes.array()).rsqrt()});
  }
}

void CommonError::take_out(std::span<double> residuals) const {
  for (const OfBall& ball : balls_) {
    Eigen::Map<Eigen::VectorXd> r(residuals.data(), ball.directions.rows());
    const Eigen::VectorXd along = ball.directions.transpose() * r;
    r -= ball.directions * ball.taken.cwiseProduct(along);
  }
}

}  // namespace rebound
