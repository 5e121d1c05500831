#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/fits/hypothesis_fit.hpp"
#include "comparisons/models/effects/effect.hpp"

namespace rebound {

/// Sequentially thresholded least squares: a sparse c with A c ≈ b.
///
///   c ← argmin |A_S c_S − b|²,  S ← {j ∈ S : |c_j| ≥ λ s_j},  until S stays
///
///   A     terms, one a column [rows][terms]
///   b     what they are to explain, in standard deviations of its noise [rows]
///   s_j   standard error of c_j; terms of a force are alike, so that the size of a coefficient
///         says little
///   λ     threshold, in standard errors
///
/// Starts from the terms in `kept` and leaves there those that stay.
/// Limit: λ = 0 is least squares -> test SparseRegressionTest.WithoutAThresholdItIsLeastSquares.
/// Source: Brunton, Proctor & Kutz 2016, Proc. Natl. Acad. Sci. 113, 3932, there λ on |c_j|.
Eigen::VectorXd thresholded_least_squares(const Eigen::MatrixXd& terms,
                                          const Eigen::VectorXd& target, double threshold,
                                          std::vector<Eigen::Index>& kept);

/// The same over rising thresholds, each from what the one before has left; that with the lowest
/// |A c − b|² + k ln N, k terms kept and N rows. No term at all is one of the choices.
/// Source: Mangan et al. 2017, Proc. R. Soc. A 473, 20170009.
Eigen::VectorXd sparse_coefficients(const Eigen::MatrixXd& terms, const Eigen::VectorXd& target);

/// What a sparse regression of a residual force has kept.
struct SparseRegression {
  std::vector<std::string> terms;  ///< e.g. "x v"
  /// Of the terms without which χ² rises most; none without terms.
  EffectFamily family = EffectFamily::none;
};

/// Regresses the residual force of a fitted model on terms of its deflection x and rate v.
///
///   F_measured − F_model ≈ Σ c_j δF_j,   δF_j what one newton of the term θ_j(x, v) does to the
///   force (force_terms.hpp)
///
/// Rows are whitened force samples. What the fit's own unknowns can absorb, to first order, is
/// taken out of residuals and terms. Validity: small terms; the motion is that of the model without
/// them. Caution: memory, and another mass that moves, have no term: this regression can never say
/// them. Source: Brunton et al. 2016, with responses in place of terms, since deflection is not
/// measured.
SparseRegression regress_residual_force(const Observations& seen, const HypothesisFit& fit);

}  // namespace rebound
