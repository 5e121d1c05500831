#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "comparisons/inference/calibration/observations.hpp"

namespace rebound {

/// What a model gets wrong in all shots of a ball alike, taken out of their residuals: the part of
/// a numerical error that repeats, and more speeds, do not average out.
///
///   C = 1 + B Bᵀ,   r ← C^(−1/2) r
///
///   B   n x 8; column k: the whitened force of an error of ForceNoise::shared in the k-th eighth
///       of the contact, falling in straight lines to its neighbours [-]
///   r   whitened residuals of all shots, one after the other [-]
///
/// Shots that hold no such error, and rows that are no force, stay as they are.
///
/// Limit:  residuals that are such an error are left with the size that it may have, however many
///         the shots -> test CommonErrorTest.ManyShotsKnowNoMoreThanOne.
/// Source: Woodbury's identity; numerical error as a covariance, ASME V&V 20.
class CommonError {
 public:
  /// `force_rows`: where the history of each shot begins among `rows` residuals.
  CommonError(const Observations& seen, const std::vector<std::size_t>& force_rows,
              std::size_t rows);

  bool is_none() const { return balls_.empty(); }
  void take_out(std::span<double> residuals) const;

 private:
  struct OfBall {
    Eigen::MatrixXd directions;  ///< orthonormal [rows][8]
    Eigen::VectorXd taken;       ///< 1 − 1/√(1 + λ) of each
  };
  std::vector<OfBall> balls_;
};

}  // namespace rebound
