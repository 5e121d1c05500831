#pragma once

#include <memory>
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

/// Does what was added take half of the excess gap at the speed no fit saw, as diagnose() asks of a
/// name? No where there is no such speed.
bool earns_name(const ScalarGap& before, const ScalarGap& after);

/// One effect more in a fitted model, and what of the data it explains.
struct EffectOnScalars {
  EffectChoice effect;  ///< with fitted numbers
  EffectFamily family{};
  double reduced_chi_square = 0.0;
  double information_criterion = 0.0;
};

/// The fits that a choice of effects rests on: none has seen the middle speed.
struct FitsOfEffects {
  std::shared_ptr<const Observations> seen;  ///< the fits look at it
  Observations unseen;
  HypothesisFit believed;
  std::vector<HypothesisFit> tried;  ///< with one effect each, best first
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
  FitsOfEffects fits;                    ///< behind them
  int cells = 0, finer_cells = 0;        ///< of the mesh, and of the one that corrects it
};

/// Are there two numbers more than the material has?
bool enough_scalars(const Observations& all, const Material& material);

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
