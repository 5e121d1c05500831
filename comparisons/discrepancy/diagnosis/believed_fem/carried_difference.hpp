#pragma once

#include <vector>

#include "comparisons/discrepancy/diagnosis/fits/modelled_impact.hpp"

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

  void apply(ModelledImpact& impact) const;
  /// The difference so many times over: scalars and the duration by powers of their ratios, as laws
  /// of power in the speed have it; the shape of the history by shares.
  void apply_times(ModelledImpact& impact, double times) const;
};

CarriedDifference difference_between(const ModelledImpact& first, const ModelledImpact& second);

/// rms difference of two force histories over the contact of the first, over its peak.
double history_difference(const ModelledImpact& a, const ModelledImpact& b);

/// Differences known at one speed of a ball.
///
/// Limit:  impacts whose scalars are powers of the speed are met at any speed
///         -> test CarriedDifferenceTest.PowersOfTheSpeedAreMet.
struct KnownDifferences {
  std::size_t ball = 0;
  double speed = 0.0;        ///< [m/s]
  CarriedDifference finer;   ///< what a finer mesh adds
  CarriedDifference faster;  ///< what a speed higher by `step` adds
  double step = 0.01;        ///< of a speed
  double reach = 0.1;        ///< of a speed: farther, an impact is run by itself

  /// The impact at this speed becomes that at another.
  void carry_to(ModelledImpact& impact, double other_speed) const;
};

}  // namespace rebound
