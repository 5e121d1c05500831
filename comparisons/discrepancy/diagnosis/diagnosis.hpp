#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/asked_fem/fitted_fem.hpp"
#include "comparisons/discrepancy/diagnosis/data_checks/data_checks.hpp"
#include "comparisons/discrepancy/diagnosis/fits/held_out_gap.hpp"
#include "comparisons/discrepancy/diagnosis/missing_force/missing_force.hpp"
#include "comparisons/discrepancy/diagnosis/next_experiment/next_experiment.hpp"
#include "comparisons/discrepancy/diagnosis/observations/measured_design.hpp"
#include "comparisons/discrepancy/diagnosis/search/free_forms.hpp"
#include "comparisons/discrepancy/diagnosis/search/selection.hpp"
#include "comparisons/discrepancy/diagnosis/search/selection_bootstrap.hpp"
#include "comparisons/discrepancy/diagnosis/verdict/candidate_family.hpp"
#include "comparisons/discrepancy/diagnosis/verdict/named_effect.hpp"
#include "comparisons/io/dataset/dataset.hpp"

/// Where a believed model and data disagree, and which named effect is missing.
namespace rebound {

enum class DiagnosisVerdict {
  agrees,
  missing,            ///< one effect, by name
  family,             ///< what the missing force depends on, but no name
  one_of,             ///< effects that the data do not tell apart
  unexplained,        ///< nothing in the list
  measurement_fault,  ///< of the measuring chain
  insufficient_data
};
constexpr auto names_of(DiagnosisVerdict) {
  return names_list<DiagnosisVerdict>({{"agrees", DiagnosisVerdict::agrees},
                                       {"missing", DiagnosisVerdict::missing},
                                       {"family", DiagnosisVerdict::family},
                                       {"one-of", DiagnosisVerdict::one_of},
                                       {"unexplained", DiagnosisVerdict::unexplained},
                                       {"measurement-fault", DiagnosisVerdict::measurement_fault},
                                       {"insufficient-data", DiagnosisVerdict::insufficient_data}});
}

/// Reduced whitened χ², 1 is the noise; absent where not computed.
struct Gap {
  std::optional<double> before, after, held_out_before, held_out_after;
  double held_out_noise = 0.0;  ///< its deviation at the unseen speed when nothing is missing
};

/// One effect that FE was asked of: a name that the lumped tier has earned, or one that was tried
/// where that has no name and FE comes near to the data.
struct EffectInFem {
  EffectChoice effect;  ///< with the numbers that FE has found, of the first ball
  EffectFamily family = EffectFamily::none;
  double information_criterion = 0.0;
  double unseen_chi_square = 0.0;  ///< of the shots that no fit saw, with the effect; 0 of none
  Gap gap;                         ///< of FE without the effect, and with it
  /// Reduced whitened χ² of the lumped model without the effect, and with it; absent where that
  /// was not fitted.
  std::optional<double> lumped_before, lumped_after;
  std::string lumped = "not-run", fem = "not-run";  ///< as those of NamedEffect
  std::vector<FittedFem> without, with;             ///< balls, as they were fitted

  /// Of all shots: what no fit saw speaks without a penalty.
  double criterion() const { return information_criterion + unseen_chi_square; }
};

/// What FE leaves shot by shot, where the verdict rests on it.
struct ShotsInFem {
  std::string effect;                      ///< empty: FE with nothing hidden follows the data
  std::vector<FittedFem> without, with{};  ///< `with` is empty where there is no effect
  /// Of the shots that were fitted, and of those that were not. A shot that FE does not look at, a
  /// second one of the same speed, has no rows.
  std::vector<ShotGap> before{}, after{}, unseen_before{}, unseen_after{};
};

struct DiagnosisRequest {
  std::vector<Dataset> datasets;
  LumpedModel believed;
  /// A believed FE model, in place of the lumped one; sphere and impact are those of the data.
  std::optional<FemProblem> believed_fem{};
  std::vector<EffectChoice> believed_effects;  ///< those the model already has
  /// Shots at this speed (as well as it is known) take no part in any fit; empty: the middle
  /// one of three speeds or more. [m/s]
  std::optional<double> held_out_speed;
  bool hold_out = true;
  /// May FE be asked what it adds to the believed model? Where it is not built: no.
  bool ask_fem = true;
  std::string mesh_file;  ///< a user's own mesh for FE; empty: mapped ones
  SelectionRules rules;
  std::uint64_t seed = 1;
};

/// A whole diagnosis: the verdict, and what it rests on.
struct Diagnosis {
  DiagnosisVerdict verdict = DiagnosisVerdict::insufficient_data;
  /// That all candidates share; none where they differ or there is nothing to explain.
  EffectFamily family = EffectFamily::none;
  std::vector<NamedEffect> effects;
  std::vector<std::vector<std::string>> candidates;  ///< sets not to be told apart
  std::vector<ExcludedSize> excluded;
  std::string fault;  ///< empty: none suspected
  std::vector<std::string> needed;
  std::vector<std::string> warnings;
  std::vector<DataCheck> checks;          ///< the data against themselves, before any model
  std::vector<DataCheck> contradictions;  ///< of these, the plain ones, largest first
  std::vector<NextExperiment> next;
  std::vector<FactorBand> curves;  ///< of a family that has no formula here
  /// Of that family: formulas that come nearest, with the share of the gap each explains.
  std::vector<ExplainedShare> nearest;
  std::vector<EffectInFem> in_fem;  ///< best first; empty where FE was asked of no effect
  /// Of FE with nothing hidden, where nothing lumped has a name; `before` and `held_out_before`
  /// alone.
  std::optional<Gap> fem_with_nothing_hidden;
  /// What the believed lumped law leaves by itself, where `gap` is with what a body of finite size
  /// adds to it; `before` and `held_out_before` alone.
  std::optional<Gap> law_alone;
  std::optional<ShotsInFem> shots_in_fem;
  /// Why there is no name; empty: there is one, or no reason beyond the verdict.
  std::string withheld;
  std::vector<MapCell> where;  ///< cells beyond the threshold, largest first
  Gap gap;
  std::optional<double> held_out_speed;
  /// Of a believed FE model: what its mesh gets wrong, over the peak force [-].
  std::optional<double> numerical_uncertainty;
  std::uint64_t seed = 0;
  MeasuredDesign design;             ///< what the experiment is like, as blind trials know it
  std::size_t believed_effects = 0;  ///< how many the model had before; they come first

  std::shared_ptr<const Observations> seen, unseen;  ///< fits point into them
  AssessedFit believed;                              ///< the model as it came, refitted
  EffectSelection selection;     ///< from there on, or from the model made consistent with itself
  SelectionBootstrap bootstrap;  ///< of the choice between its candidates, where there are some
  /// FE minus lumped, where the data were explained with it only.
  std::shared_ptr<const ModelDiscrepancy> model_discrepancy;
  /// The same wherever FE was asked, with the balls as FE alone would have them.
  std::shared_ptr<const ModelDiscrepancy> fem_alone;
  std::optional<HeldOutGap> unseen_before, unseen_after;
  /// What the model that the search started from lacks, without a formula; absent where nothing
  /// is missing from it.
  std::optional<MissingForce> missing_force;

  /// Of a cell of the map [m/s]; zero for a slow compression.
  double speed_of(const MapCell& cell) const {
    return cell.shot < seen->shots.size() ? seen->shots[cell.shot].impact.speed : 0.0;
  }
  /// Is the residual map, and are the residuals of shots, those of the law alone?
  bool maps_the_law_alone() const { return law_alone && !model_discrepancy; }
  /// Has the search, or the repair of a formula, added to the believed model?
  bool extended() const { return best().effects.size() > believed_effects; }
  /// The fit that the verdict rests on: the best candidate, or what the search
  /// started from.
  const HypothesisFit& best() const { return selection.best(); }
};

/// Runs the workflow.
///
///   1 noise and uncertainties from the data set, or a warning; the data against themselves
///   2 the believed model fitted jointly to all speeds but one; of an FE model the numerical
///     uncertainty joins the errors of the data (settle_fem)
///   3 a damping formula that does not return the restitution it was given
///     contradicts the model's own input: it is set right before anything is
///     added to the model
///   4 effects searched on what is left (select_effects)
///   5 where there is a gap: again with what FE adds to the believed model taken into account,
///     which takes the place of effects that it explains as well (search_beside_fem)
///   6 prediction of the speed that was left out, before and after
///   7 verdict; the choice it rests on made again on repeated data (bootstrap_selection); where
///     FE was asked, names that have a form there tried in FE as well (ask_fem_of_names)
///   8 where nothing lumped has a name and FE comes near to the data: effects in FE, one at a time
///     (look_for_effects_in_fem); where FE with nothing hidden follows them: those that gain much
///     all the same (look_for_weak_effects_in_fem)
///   9 where something is missing from the physics: the missing force, without a formula
///
/// Errors: Error(bad_input) for a model that has no numbers at a speed of the
///         data, or for an FE model of the implicit scheme; Error(interrupted).
Diagnosis diagnose(const DiagnosisRequest& request, const RunControl& control = {});

}  // namespace rebound
