#pragma once

#include <vector>

#include "comparisons/discrepancy/diagnosis/modelled_impact.hpp"

namespace rebound {

/// What tells two impacts apart, carried over to an impact of nearly the same material and speed:
/// force and deflection over their peaks by the phase of the contact, scalars as ratios.
///
/// Of a finer mesh it corrects a coarse one; of a slightly higher speed it makes a small change of
/// speed without an impact of its own.
///
/// Valid:   impacts with the same number of instants, at equal phases.
/// Limit:   of the first impact it makes the second
///          -> test CarriedDifferenceTest.MakesTheSecondImpactOfTheFirst.
/// Caution: a contact front passes the nodes at other phases where the contact is larger: what a
///          correction is worth at another material is measured, not assumed (settle_fem).
struct CarriedDifference {
  std::vector<double> force, deflection;
  double duration = 1.0;  ///< of the trace
  double restitution = 1.0, rebound_speed = 1.0, contact_time = 1.0, contact_time_1pct = 1.0,
         peak_force = 1.0, peak_deflection = 1.0, mean_deflection = 1.0;

  /// `share` of the difference added.
  void apply(ModelledImpact& impact, double share = 1.0) const;
};

CarriedDifference difference_between(const ModelledImpact& first, const ModelledImpact& second);

/// rms difference of two force histories over the contact of the first, over its peak.
double history_difference(const ModelledImpact& a, const ModelledImpact& b);

/// Differences known at one speed of a ball.
struct KnownDifferences {
  std::size_t ball = 0;
  double speed = 0.0;        ///< [m/s]
  CarriedDifference finer;   ///< what a finer mesh adds
  CarriedDifference faster;  ///< what a speed one per cent higher adds
};

}  // namespace rebound
