#pragma once

#include <Eigen/Core>
#include <vector>

namespace rebound {

/// What numbers cost a criterion χ² + c k.
struct CostOfNumbers {
  double numbers = 0.0;          ///< k
  double lost_chi_square = 0.0;  ///< where they are made so smooth

  double with(double each) const { return lost_chi_square + numbers * each; }
};

/// Numbers of a fit, some of them points of curves.
struct FittedNumbers {
  Eigen::VectorXd value;                   ///< g
  Eigen::MatrixXd covariance;              ///< C, all else refitted
  Eigen::VectorXd prior;                   ///< P, inverse variances; 0: none
  std::vector<Eigen::MatrixXd> roughness;  ///< DᵀD of the second differences of each curve
};

/// Curves as smooth as the criterion wants them: many points that lie on a line or a bow are no
/// many numbers.
///
///   S = C⁻¹ + Σ DᵢᵀDᵢ/σᵢ²     k = tr S⁻¹ (C⁻¹ − P)     lost = (S⁻¹C⁻¹g − g)ᵀ C⁻¹ (S⁻¹C⁻¹g − g)
///
/// σᵢ is that of least lost + c k, from 1e-5 to 1 in steps of √10, or infinite; each in turn,
/// twice.
///
/// Valid:   to first order about the fit.
/// Limit:   σ infinite: k = Σ (1 − s²/σ_prior²) -> test SmoothedNumbersTest.APriorTakesItsShare;
///          points on a line cost what a line does -> test SmoothedNumbersTest.ALineIsTwoNumbers;
///          rough ones cost what they are -> test SmoothedNumbersTest.WhatIsRoughStaysSo.
/// Source:  penalised splines and their effective number, Hastie & Tibshirani 1990, ch. 3.
CostOfNumbers smoothest(const FittedNumbers& numbers, double each);

}  // namespace rebound
