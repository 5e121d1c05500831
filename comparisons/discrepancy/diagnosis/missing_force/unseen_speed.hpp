#pragma once

#include "comparisons/discrepancy/diagnosis/fits/held_out_gap.hpp"
#include "comparisons/discrepancy/diagnosis/missing_force/force_rows.hpp"
#include "comparisons/discrepancy/diagnosis/missing_force/missing_force.hpp"

namespace rebound {

/// All that was found of a missing force.
struct FoundForce {
  const ForceRows& rows;
  const ForceSurface& surface;
  std::vector<double> values;  ///< of the fit's unknowns, nuisances moved to where they belong
};

/// Runs the impacts of one ball that no fit saw, under the law and under law and missing force,
/// and writes the reduced χ² of their histories into `missing`.
///
///   f(x, v, v*) by the Gaussian process at v*,   x_max(v*) linear in ln x_max over ln v₀
///
/// Start and speed of each shot are found within their priors, as predict_unseen() does.
/// Limit: predicts within the noise -> test MissingForceTest.BandCoversAndPredictsTheUnseenSpeed.
void predict_with_missing_force(const Observations& unseen, std::size_t ball,
                                const HypothesisFit& fit, const FoundForce& found,
                                MissingForce& missing);

}  // namespace rebound
