#include "comparisons/discrepancy/diagnosis/asked_fem/beside_fem.hpp"

#include <fmt/format.h>

#include "comparisons/discrepancy/diagnosis/asked_fem/model_discrepancy.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/plates_of_lumped.hpp"
#include "comparisons/discrepancy/diagnosis/fits/held_out_gap.hpp"
#include "comparisons/discrepancy/diagnosis/fits/hypothesis_fit.hpp"
#include "comparisons/discrepancy/diagnosis/search/believed_fit.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr double plainly_nearer = 25.0;  // in χ², as seen against the noise of the data alone

/// The best candidate; null where there is none, or where one holds a plate: FE's ball may stand
/// on that, and what it leaves on a rigid one says nothing.
const HypothesisFit* explanation_on_rigid_plate(const EffectSelection& found) {
  if (found.indistinguishable.empty()) return nullptr;
  for (const std::size_t candidate : found.indistinguishable)
    for (const EffectChoice& effect : found.tried[candidate].fit.effects)
      if (is_plate(effect.name)) return nullptr;
  return &found.best();
}

/// Is what FE adds worth a search of its own?
bool comes_near(const Diagnosis& d, const HypothesisFit& with_fem) {
  const double gained = d.selection.baseline.fit.chi_square - with_fem.chi_square;
  if (gained <= plainly_nearer) return false;
  if (d.selection.indistinguishable.empty()) return true;
  return gained >=
         share_worth_a_search * (d.selection.baseline.fit.chi_square - d.best().chi_square);
}

/// Does what was found beside FE take the place of what was found without?
bool takes_its_place(const Diagnosis& d, const EffectSelection& beside, const Observations& seen,
                     const SelectionRules& rules, const RunControl& control) try {
  if (!beside.explains()) return false;
  if (!d.selection.explains()) return true;
  const HypothesisFit& with_fem = beside.best();
  // On the same errors: those of FE are among them now.
  const HypothesisFit without = fit_further(seen, d.best(), control);
  const double allowed =
      with_fem.effects.size() < without.effects.size() ? rules.close_criterion : 0.0;
  return with_fem.information_criterion <= without.information_criterion + allowed;
} catch (const Error& error) {
  if (error.code() != ExitCode::solver_failed) throw;
  return true;  // what has no fit from where it stands is no rival
}

}  // namespace

void search_beside_fem(Diagnosis& d, const DiagnosisRequest& request, const Hypothesis& believed,
                       const Observations& all, const RunControl& whole) try {
  constexpr double fem_fit_share = 0.7;  // of a diagnosis that asks FE
  const RunControl control{.interrupted = whole.interrupted};
  const auto gap = std::make_shared<const ModelDiscrepancy>(
      measure_model_discrepancy(all, *d.seen,
                                {.law = d.selection.baseline.fit,
                                 .plates = plates_worth_a_search(d.selection, *d.seen),
                                 .explanation = explanation_on_rigid_plate(d.selection)},
                                {.file = request.mesh_file}, control));
  d.fem_alone = gap;
  if (whole.progress) whole.progress(fem_fit_share);
  Hypothesis baseline = d.selection.baseline.fit.hypothesis, believed_with_gap = believed;
  baseline.model_discrepancy = believed_with_gap.model_discrepancy = gap;
  // On a plate that moves FE has come near already, and the lumped model does with that plate only.
  if (!gap->plate_moves() && !comes_near(d, fit_hypothesis(*d.seen, baseline, control))) return;
  const auto seen = std::make_shared<const Observations>(with_numerical_uncertainty(*d.seen, *gap));
  const std::vector<std::string> effects = absent_effects(baseline.effects);
  EffectSelection selection =
      select_effects(*seen,
                     judge_believed(*seen, fit_hypothesis(*seen, baseline, control), effects,
                                    request.rules, request.seed),
                     effects, request.rules, request.seed, control);
  if (!takes_its_place(d, selection, *seen, request.rules, control)) return;
  d.law_alone = Gap{.before = d.believed.fit.reduced_chi_square()};
  if (d.held_out_speed)
    d.law_alone->held_out_before = predict_unseen(*d.unseen, d.believed.fit).reduced_chi_square;
  d.believed = assess_believed(*seen, believed_with_gap, request.rules, request.seed, control);
  d.selection = std::move(selection);
  d.model_discrepancy = gap;
  d.seen = seen;
  d.unseen = std::make_shared<const Observations>(with_numerical_uncertainty(*d.unseen, *gap));
  d.warnings.push_back(fmt::format(
      "the data follow a body of finite size: what FE adds to the lumped model (waves, finite "
      "strain) was taken into account, with {:.2g} % of the peak force as its numerical "
      "uncertainty",
      100.0 * gap->numerical_uncertainty));
} catch (const Error& error) {
  if (error.code() != ExitCode::solver_failed) throw;
  d.warnings.push_back(fmt::format("FE could not be asked: {}", error.what()));
}

}  // namespace rebound
