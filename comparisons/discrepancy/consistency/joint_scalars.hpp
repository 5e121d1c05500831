#pragma once

#include <optional>
#include <vector>

#include "comparisons/discrepancy/consistency/joint_consistency.hpp"
#include "comparisons/discrepancy/consistency/joint_effects.hpp"

namespace rebound {

/// Several balls, each with its own believed FE model, beside all scalars that were measured of
/// them.
struct JointScalars {
  JointConsistency consistency;        ///< on all shots
  std::optional<double> unseen_speed;  ///< where it is one for all balls [m/s]
  JointEffects effects;

  /// Without an effect more, and with the first of them.
  const JointGap& believed() const { return effects.believed; }
  const JointGap& extended() const {
    return effects.effects.empty() ? effects.believed : effects.effects.front().chosen().gap;
  }
  /// Does the first effect take half of the excess gap at the unseen speed?
  bool earns_a_name() const {
    return !effects.effects.empty() && earns_name(believed().all, extended().all);
  }
};

/// Which observables of several balls contradict the others, and which one effect more would bring
/// all of them closest, shown at a speed that no fit has seen. It goes on from the fits apart.
///
/// Valid:  two balls or more.
/// Errors: those of compare_jointly() and try_effects_jointly().
JointScalars diagnose_jointly(const std::vector<const ScalarDiagnosis*>& apart,
                              const RunControl& control = {});

}  // namespace rebound
