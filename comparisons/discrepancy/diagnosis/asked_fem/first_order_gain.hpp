#pragma once

#include <Eigen/Dense>

namespace rebound {

/// What adding an effect would do to χ², to first order.
struct FirstOrderGain {
  double chi_square = 0.0;  ///< by how much it falls, ≥ 0
  double factor =
      0.0;  ///< the multiple of the effect at which it does; negative: of the other sign
};

/// The fitted numbers of a model, and what a change of its residuals gains beside them.
///
///   r    residuals at the fit, J their slopes by its numbers, δ the change
///   P    projection on what J does not reach
///
///   gain = (r · P δ)² / |P δ|²,   factor = −(r · P δ)/|P δ|²
///
/// Limit:   a change that the numbers can make gains nothing
///          -> test FirstOrderGainTest.WhatTheNumbersCanDoGainsNothing
class BesideFittedNumbers {
 public:
  BesideFittedNumbers(Eigen::VectorXd residuals, const Eigen::MatrixXd& slopes);

  /// Several models share one effect: their sums add up.
  struct Sums {
    double along = 0.0;   ///< r · P δ
    double square = 0.0;  ///< |P δ|²; 0: the numbers can do nearly all of it

    Sums& operator+=(const Sums& other);
    FirstOrderGain gain() const;
    /// Of an effect that is no multiple of anything, as a level at which readings end: what it does
    /// to χ² as it stands, 0 where that rises; its factor is 1.
    FirstOrderGain gain_as_it_stands() const;
  };
  Sums sums_of(const Eigen::VectorXd& change) const;

  /// P r of other residuals r.
  Eigen::VectorXd left(const Eigen::VectorXd& residuals) const;

  const Eigen::VectorXd& residuals() const { return residuals_; }

 private:
  Eigen::VectorXd residuals_;
  Eigen::MatrixXd reached_;  ///< orthonormal columns that span J
};

}  // namespace rebound
