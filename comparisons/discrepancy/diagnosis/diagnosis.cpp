#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "comparisons/discrepancy/diagnosis/asked_fem/beside_fem.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/effects_in_fem.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/fem_of_balls.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/names_in_fem.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/weak_effects_in_fem.hpp"
#include "comparisons/discrepancy/diagnosis/believed_fem/fem_search.hpp"
#include "comparisons/discrepancy/diagnosis/believed_fem/settled_fem.hpp"
#include "comparisons/discrepancy/diagnosis/data_checks/force_before_touch.hpp"
#include "comparisons/discrepancy/diagnosis/fits/held_out_gap.hpp"
#include "comparisons/discrepancy/diagnosis/fits/held_out_speed.hpp"
#include "comparisons/discrepancy/diagnosis/fits/slow_comparisons.hpp"
#include "comparisons/discrepancy/diagnosis/observations/observe.hpp"
#include "comparisons/discrepancy/diagnosis/search/believed_fit.hpp"
#include "comparisons/discrepancy/diagnosis/verdict/contradictions.hpp"
#include "comparisons/discrepancy/diagnosis/verdict/shots_that_differ.hpp"
#include "comparisons/discrepancy/diagnosis/verdict/suspected_fault.hpp"
#include "comparisons/discrepancy/diagnosis/verdict/verdict.hpp"
#include "comparisons/discrepancy/diagnosis/verdict/withheld_name.hpp"
#include "comparisons/models/fem_access/module_loader.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// What the data lack for any verdict; empty when they are enough.
std::vector<std::string> lacking(const Observations& seen, const Hypothesis& baseline) {
  std::vector<std::string> needed = seen.missing;
  if (seen.shots.empty()) return needed;
  const JointModel model(seen, baseline);
  const auto unknowns = model.unknowns().size();
  const auto priors = model.residuals(model.start()).size() - model.rows().size();
  // With nothing over, every model fits and none can be told from another.
  if (model.rows().size() < unknowns - priors + 2)
    needed.push_back(
        fmt::format("more data: {} numbers for {} unknowns; a force history with its "
                    "noise, or further speeds",
                    model.rows().size(), unknowns - priors));
  return needed;
}

/// The believed model with its damping given by the exact relation, where it is
/// given by a formula that contradicts its own restitution and the data see it.
AssessedFit made_consistent(const Observations& seen, const AssessedFit& believed,
                            const SelectionRules& rules, std::uint64_t seed) {
  if (believed.fit.hypothesis.believed.damping_formula.empty()) return believed;
  Hypothesis exact = believed.fit.hypothesis;
  exact.effects.push_back({.name = "low-loss-damping-formula", .size = 1.0, .parameters = {}});
  try {
    HypothesisFit repaired = fit_hypothesis(seen, exact);
    if (repaired.chi_square < believed.fit.chi_square - rules.close_criterion)
      return judge_believed(seen, std::move(repaired), absent_effects(exact.effects), rules, seed);
  } catch (const Error& error) {
    if (error.code() != ExitCode::bad_input) throw;  // no such effect for this law
  }
  return believed;
}

/// Shares of a diagnosis done when its parts end; measured on one that asks FE.
constexpr double baseline_share = 0.05, lumped_share = 0.4;

void report_progress(const RunControl& whole, double fraction) {
  if (whole.progress) whole.progress(fraction);
}

void search(Diagnosis& d, const DiagnosisRequest& request, const Hypothesis& believed,
            const Observations& all, const RunControl& whole) {
  const RunControl control{.interrupted = whole.interrupted};  // parts do not know the whole
  d.believed = assess_believed(*d.seen, believed, request.rules, request.seed, control);
  report_progress(whole, baseline_share);
  const AssessedFit baseline = made_consistent(*d.seen, d.believed, request.rules, request.seed);
  const UnseenSpeed unseen = d.held_out_speed ? UnseenSpeed{d.unseen.get(), &all} : UnseenSpeed{};
  d.selection = select_effects(*d.seen, baseline, absent_effects(baseline.fit.hypothesis.effects),
                               request.rules, request.seed, control, unseen);
  report_progress(whole, lumped_share);
  const bool has_history = std::any_of(d.seen->shots.begin(), d.seen->shots.end(),
                                       [](const MeasuredImpact& s) { return s.has_history(); });
  const bool agrees = d.selection.baseline.adequate && d.selection.indistinguishable.empty();
  if (!agrees && request.ask_fem && has_fem_tier() && has_history)
    search_beside_fem(d, request, believed, all, whole);
}

void predict_held_out(Diagnosis& d) {
  d.unseen_before = predict_unseen(*d.unseen, d.believed.fit);
  d.gap.held_out_before = d.unseen_before->reduced_chi_square;
  d.gap.held_out_noise = d.unseen_before->deviation;
  if (!d.extended()) return;
  d.unseen_after = predict_unseen(*d.unseen, d.best());
  d.gap.held_out_after = d.unseen_after->reduced_chi_square;
}

/// Where FE has an idea of the balls: what it says of names; of effects where nothing lumped has
/// one, be it of a family; of weak ones where it agrees in place of the law.
void ask_fem(Diagnosis& d, const Observations& all, const SelectionRules& rules,
             const RunControl& control) {
  const bool has_names =
      d.verdict == DiagnosisVerdict::missing || d.verdict == DiagnosisVerdict::one_of;
  if (has_names && conclude_from_what_candidates_share(d, all, rules, control)) return;
  if (has_names) ask_fem_of_names(d, all, rules, control);
  const bool has_no_name =
      d.verdict == DiagnosisVerdict::unexplained ||
      (d.verdict == DiagnosisVerdict::family && d.in_fem.empty()) ||
      (d.verdict == DiagnosisVerdict::one_of && d.family == EffectFamily::none);
  if (has_no_name) look_for_effects_in_fem(d, all, rules, control);
  if (d.verdict == DiagnosisVerdict::agrees && d.law_alone)
    look_for_weak_effects_in_fem(d, all, control);
}

/// What is missing is shown as a force, whatever it is called; a fault of the measurement is none.
void show_missing_force(Diagnosis& d) {
  const bool missing =
      d.verdict == DiagnosisVerdict::missing || d.verdict == DiagnosisVerdict::one_of ||
      d.verdict == DiagnosisVerdict::family || d.verdict == DiagnosisVerdict::unexplained;
  if (!missing) return;
  if (d.best().model->fem()) {
    d.missing_force =
        MissingForce{.not_found_because = "it is looked for beside a lumped law, not in FE"};
    return;
  }
  if (d.maps_the_law_alone()) {
    d.missing_force = MissingForce{.not_found_because =
                                       "it would be the error of the lumped law, which FE with "
                                       "nothing hidden does not have"};
    return;
  }
  try {
    d.missing_force = find_missing_force(*d.seen, d.selection.baseline.fit,
                                         d.held_out_speed ? d.unseen.get() : nullptr);
  } catch (const Error& error) {  // a verdict stands without it
    d.missing_force = MissingForce{.not_found_because = error.what()};
  }
}

}  // namespace

Diagnosis diagnose(const DiagnosisRequest& request, const RunControl& control) {
  Diagnosis d;
  d.seed = request.seed;
  Observations all = observe(request.datasets);
  if (request.believed_fem)  // a slow test is no impact of FE
    for (SlowCompression& test : all.compressions) test.compared_only = true;
  d.warnings = all.warnings;
  d.design = measured_design(request.datasets, all);
  d.checks = check_data(all);
  for (const Dataset& dataset : request.datasets)
    if (const auto check = force_before_touch(dataset)) d.checks.push_back(*check);
  d.contradictions = contradictions_among(d.checks);
  const auto held_out =
      request.hold_out ? choose_held_out(all, request.held_out_speed) : std::nullopt;
  if (held_out) d.held_out_speed = held_out->speed;
  PartedShots parts = part_at(all, held_out);
  d.seen = std::make_shared<const Observations>(std::move(parts.seen));
  d.unseen = std::make_shared<const Observations>(std::move(parts.unseen));
  if (!d.held_out_speed && request.hold_out)
    d.warnings.push_back(
        "fewer than three speeds: none could be left out to test the extended model");

  d.believed_effects = request.believed_effects.size();
  Hypothesis baseline{.believed = request.believed,
                      .effects = request.believed_effects,
                      .model_discrepancy = nullptr};
  if (request.believed_fem)
    baseline.fem = std::make_shared<const FemBelief>(
        *request.believed_fem, all,
        std::vector<Material>(all.balls.size(), request.believed_fem->material), search_cells,
        control);
  d.needed = lacking(*d.seen, baseline);
  if (!d.needed.empty()) return d;

  if (baseline.fem)
    search_in_fem(d, request, all, control);
  else
    search(d, request, baseline, all, control);
  for (const DataCheck& one : compare_slow_tests(*d.seen, d.believed.fit)) d.checks.push_back(one);
  conclude(d, request.rules);
  d.gap.before = d.believed.fit.reduced_chi_square();
  if (d.extended()) d.gap.after = d.best().reduced_chi_square();
  if (d.held_out_speed) predict_held_out(d);
  withhold_what_the_unseen_speed_denies(d, request.rules);
  withhold_names_from_contradictions(d, all);
  if (!d.selection.indistinguishable.empty()) {
    d.bootstrap = bootstrap_selection(d.selection, request.rules.bootstrap_draws, request.seed);
    withhold_what_repetition_denies(d, request.rules);
  }
  if (d.fem_alone) ask_fem(d, all, request.rules, {.interrupted = control.interrupted});
  if (d.shots_in_fem) measure_shots_in_fem(d, all, {.interrupted = control.interrupted});
  suspect_what_contradicts_momentum(d, all);
  suspect_a_shot_that_no_fit_saw(d);
  suspect_a_coarse_recorder(d, request.rules);
  suspect_an_offset(d);
  withhold_what_shots_alone_explain(d, all);
  withhold_what_acts_before_touch(d);
  find_nearest_formulas(d);
  show_missing_force(d);
  return d;
}

}  // namespace rebound
