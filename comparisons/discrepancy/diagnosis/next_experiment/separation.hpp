#pragma once

#include <Eigen/Core>

#include "comparisons/discrepancy/diagnosis/fits/hypothesis_fit.hpp"
#include "comparisons/discrepancy/diagnosis/next_experiment/experiments.hpp"

namespace rebound {

/// A fitted model, and how firmly the data at hand hold its numbers.
struct HeldFit {
  const HypothesisFit* fit = nullptr;
  /// √(JᵀJ), J the residuals' slopes by every unknown over its scale, priors included [n][n].
  Eigen::MatrixXd stiffness;
};

/// Errors: those of the model's impacts.
HeldFit held_by_the_data(const HypothesisFit& fit);

/// By how much χ² of a rival would rise on an experiment that goes as `truth` says, the rival
/// fitted again to old and new data together:
///
///   Δχ² = min over δ, n of |(A − B − G δ − N n)/σ|² + δᵀ Jᵀ J δ + |n/s|²
///
///   A, B   what truth and rival, as fitted, predict for the new record
///   G      slopes of B by the rival's own numbers over their scales
///   δ      change of these numbers; those that belong to one old shot stay
///   N, n   start and zero of a force or deflection, without a prior; scale of a slow force,
///          within s = 5 %
///   σ      noise of the force histories at hand, by their independent samples; else 1 % of the
///          peak
///
/// Valid: to first order in δ: a rival whose bounds or curvature stop it separates further.
/// Limit: a model separates from itself by nothing, and no refit raises χ²
///        -> test NextExperimentTest.ARivalThatIsFittedAgainComesNearer.
/// Errors: Error(solver_failed) where an impact of the experiment has no answer.
double expected_separation(const Observations& seen, const HeldFit& truth, const HeldFit& rival,
                           const PlannedExperiment& experiment);

}  // namespace rebound
