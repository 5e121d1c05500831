#pragma once

#include <optional>
#include <vector>

#include "comparisons/discrepancy/consistency/all_scalars.hpp"
#include "comparisons/discrepancy/consistency/effects_on_scalars.hpp"
#include "comparisons/discrepancy/consistency/observable_consistency.hpp"
#include "fem/interface/fem_problem.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound {

/// How far a model is from data that were fitted, and from a speed that no fit saw; reduced χ², 1
/// for noise alone.
struct ScalarGap {
  double fitted = 0.0;
  std::optional<double> unseen;
};

/// A believed FE model of one ball beside all scalars that were measured of it.
struct ScalarDiagnosis {
  Observations all;
  ObservableConsistency consistency;  ///< on all shots
  Material material;                  ///< fitted to all
  std::optional<double> unseen_speed;
  ScalarGap believed;  ///< fitted without the unseen speed, for the effects to be compared with
  std::vector<EffectOnScalars> effects;  ///< on what that fit saw; best first
  ScalarGap extended;                    ///< with the first of them
  int cells = 0, finer_cells = 0;        ///< of the mesh, and of the one that corrects it
};

/// Holds an FE model against the scalars of a ball: which of them contradict each other, and which
/// effect more would bring it closest, shown at a speed that no fit has seen.
///
///   unknowns   modulus, ratios and times of `believed`; the speed of each shot within its error
///
/// Three numbers of a shot tell less than its history would: the effect that is best here is a
/// direction, and no verdict of diagnose().
///
/// Errors: Error(bad_input) for fewer data than unknowns; those of settle_fem() and
/// compare_observables().
ScalarDiagnosis diagnose_scalars(const Dataset& data, const FemProblem& believed,
                                 const AssumedErrors& assumed, const RunControl& control = {});

}  // namespace rebound
