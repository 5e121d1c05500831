#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/hypothesis_fit.hpp"
#include "comparisons/models/effects/effect.hpp"

namespace rebound {

/// Sequentially thresholded least squares: a sparse c with A c ≈ b.
///
///   c ← argmin |A_S c_S − b|²,  S ← {j ∈ S : |c_j| |a_j| ≥ λ},  until S stays
///
///   A   terms, one a column [rows][terms]
///   b   what they are to explain, in standard deviations of its noise [rows]
///   λ   threshold, in the same standard deviations
///
/// Limit: λ = 0 is least squares -> test SparseRegressionTest.WithoutAThresholdItIsLeastSquares.
/// Source: Brunton, Proctor & Kutz 2016, Proc. Natl. Acad. Sci. 113, 3932.
Eigen::VectorXd thresholded_least_squares(const Eigen::MatrixXd& terms,
                                          const Eigen::VectorXd& target, double threshold);

/// The same with the threshold that gives the lowest |A c − b|² + k ln N among a grid of them, k
/// terms kept and N rows; no term at all is one of the choices.
/// Source: Mangan et al. 2017, Proc. R. Soc. A 473, 20170009.
Eigen::VectorXd sparse_coefficients(const Eigen::MatrixXd& terms, const Eigen::VectorXd& target);

/// A term of a force, kept by a sparse regression.
struct SparseTerm {
  std::string term;  ///< e.g. "x v"
  EffectFamily family = EffectFamily::none;
  double coefficient = 0.0;  ///< of x over its largest and v over its largest [N]
  Eigen::VectorXd moved;     ///< a c: what it does to the whitened residuals [rows]
};

/// Regresses the residual force of a fitted model on terms of its deflection x and rate v.
///
///   F_measured − F_model ≈ Σ c_j θ_j(x, v),
///   θ: 1 in the whole record; in contact 1, x, x^1.5, x², x³, v, √x v, x v, v|v|, sgn v, x sgn v
///
/// Rows are whitened force samples. What the fit's own unknowns can absorb, to first order, is
/// taken out of residuals and terms. Validity: to first order, since the path of the ball is that
/// of the model without the terms. Caution: memory, and another mass that moves, have no term: this
/// regression can never say them. Source: Brunton et al. 2016.
std::vector<SparseTerm> regress_residual_force(const Observations& seen, const HypothesisFit& fit);

/// The family of which the terms together move most of the residuals, |Σ a c|²; none without terms.
/// Terms of one family may cancel each other, so that none of them counts by itself.
EffectFamily family_of_terms(const std::vector<SparseTerm>& terms);

}  // namespace rebound
