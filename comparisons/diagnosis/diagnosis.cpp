#include "comparisons/diagnosis/diagnosis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "comparisons/diagnosis/tier_gap.hpp"
#include "comparisons/modules/module_loader.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr double same_speed = 1e-6;

/// What may be missing: everything in the list that the model does not have.
std::vector<std::string> absent_effects(const std::vector<EffectChoice>& present) {
  std::vector<std::string> names;
  for (const Effect& effect : all_effects()) {
    const bool known = std::any_of(present.begin(), present.end(), [&](const EffectChoice& e) {
      return e.name == effect.card.name;
    });
    if (!known && (effect.to_lumped || effect.to_measurement)) names.push_back(effect.card.name);
  }
  return names;
}

/// The speed that is kept from every fit; empty when there are too few.
std::optional<double> choose_held_out(const DiagnosisRequest& request, const Observations& all) {
  if (!request.hold_out) return std::nullopt;
  std::set<double> speeds;
  for (const auto& shot : all.shots) speeds.insert(shot.speed);
  if (request.held_out_speed) {
    for (const double speed : speeds)
      if (std::abs(speed / *request.held_out_speed - 1.0) < same_speed) return speed;
    throw Error(ExitCode::bad_input, "no shot of the data has the speed to be held out",
                {.key = "hold-out", .value = fmt::format("{:g} m/s", *request.held_out_speed)});
  }
  constexpr std::size_t fewest_speeds = 3;
  if (speeds.size() < fewest_speeds) return std::nullopt;
  return *std::next(speeds.begin(), static_cast<std::ptrdiff_t>(speeds.size() / 2));
}

NumberWithInterval with_interval(const HypothesisFit& fit, std::size_t unknown,
                                 const std::string& name, bool logarithmic) {
  const Estimate& e = fit.search.estimates[unknown];
  const auto back = [&](double x) { return logarithmic ? std::exp(x) : x; };
  return {.name = name, .value = back(e.value), .low = back(e.low), .high = back(e.high)};
}

NamedEffect named(const HypothesisFit& fit, std::size_t k) {
  const EffectChoice& choice = fit.effects[k];
  const Effect& effect = find_effect(choice.name);
  NamedEffect result{.effect = choice,
                     .size = {.name = choice.name, .value = choice.size, .low = choice.size,
                              .high = choice.size},
                     .parameters = {}};
  if (!effect.to_fem) result.fem = "no-form";
  if (!effect.to_lumped) result.lumped = "no-form";
  const auto& unknowns = fit.model->unknowns_of_effect(k);
  if (unknowns.empty()) return result;
  result.size = with_interval(fit, unknowns[0], choice.name, false);
  std::size_t next = 1;
  for (const auto& parameter : effect.card.parameters)
    if (parameter.fitted)
      result.parameters.push_back(with_interval(fit, unknowns[next++], parameter.name, true));
  return result;
}

bool is_measurement(const std::string& name) {
  return find_effect(name).card.kind == EffectKind::measurement;
}

/// Effects that a fit has beyond those of the believed model.
std::vector<std::string> added_effects(const Diagnosis& d, const HypothesisFit& fit) {
  std::vector<std::string> names;
  for (std::size_t k = d.believed_effects; k < fit.effects.size(); ++k)
    names.push_back(fit.effects[k].name);
  return names;
}

void conclude_from_candidates(Diagnosis& d) {
  std::vector<const HypothesisFit*> fits;
  for (const std::size_t i : d.selection.confusable) fits.push_back(&d.selection.tried[i].fit);
  if (fits.empty()) fits.push_back(&d.selection.baseline.fit);  // set right by its formula alone
  for (const auto* fit : fits) d.candidates.push_back(added_effects(d, *fit));
  const auto in_all = [&](const std::string& name) {
    return std::all_of(d.candidates.begin(), d.candidates.end(), [&](const auto& names) {
      return std::find(names.begin(), names.end(), name) != names.end();
    });
  };
  for (std::size_t k = d.believed_effects; k < fits.front()->effects.size(); ++k)
    if (in_all(fits.front()->effects[k].name)) d.effects.push_back(named(*fits.front(), k));
  const bool only_measurement =
      std::all_of(d.candidates.begin(), d.candidates.end(), [](const auto& names) {
        return std::all_of(names.begin(), names.end(), is_measurement);
      });
  if (only_measurement) {
    d.verdict = DiagnosisVerdict::measurement_fault;
    for (const auto* fit : fits) d.fault += (d.fault.empty() ? "" : " or ") + label_of(fit->effects);
  } else {
    d.verdict = fits.size() == 1 ? DiagnosisVerdict::missing : DiagnosisVerdict::one_of;
  }
  if (fits.size() > 1) d.next = next_experiments(*d.seen, fits, SelectionRules{}.close_criterion);
}

/// Data that are left to contradict a fit: less what was fitted, and less the
/// restitutions that a damping formula was given.
int contradicting_data(const Observations& seen, const HypothesisFit& fit) {
  int inputs = 0;
  if (!fit.hypothesis.believed.damping_formula.empty())
    for (const ObservedShot& shot : seen.shots) inputs += shot.restitution ? 1 : 0;
  const auto priors = static_cast<int>(fit.residuals.size() - fit.data_rows());
  return static_cast<int>(fit.data_rows()) - inputs - (static_cast<int>(fit.values.size()) - priors);
}

/// A single set that fits because nothing was left to contradict it carries no name.
void withdraw_what_cannot_fail(Diagnosis& d) {
  if (d.selection.confusable.size() != 1) return;
  const HypothesisFit& fit = d.best();
  if (contradicting_data(*d.seen, fit) > 0) return;
  d.needed.push_back(fmt::format(
      "data that could contradict it: {} fits what is left, but with as many numbers as there are "
      "data; force histories, or further speeds", label_of(fit.effects)));
  d.selection.confusable.clear();
}

void conclude_agreement(Diagnosis& d) {
  d.verdict = DiagnosisVerdict::agrees;
  constexpr double one_sided = 1.645;  // 95 % of a normal
  for (const EffectScore& score : d.selection.scores) {
    const EffectCard& card = find_effect(score.name).card;
    if (card.is_switch || !std::isfinite(card.null)) continue;
    const double reach = std::abs(score.size) + one_sided * score.size_error;
    if (reach < card.highest) d.excluded.push_back({score.name, reach});
  }
}

void locate(Diagnosis& d) {
  const ResidualMap& map = d.believed.map;
  for (const MapCell& cell : map.cells)
    if (std::abs(cell.z) > map.threshold) d.where.push_back(cell);
  std::stable_sort(d.where.begin(), d.where.end(), [](const MapCell& a, const MapCell& b) {
    return std::abs(a.z) > std::abs(b.z);
  });
}

/// What the data lack for any verdict; empty when they are enough.
std::vector<std::string> lacking(const Observations& seen, const Hypothesis& baseline) {
  std::vector<std::string> needed = seen.missing;
  if (seen.shots.empty()) return needed;
  const JointModel model(seen, baseline);
  const auto unknowns = model.unknowns().size();
  const auto priors = model.residuals(model.start()).size() - model.rows().size();
  // With nothing over, every model fits and none can be told from another.
  if (model.rows().size() < unknowns - priors + 2)
    needed.push_back(fmt::format("more data: {} numbers for {} unknowns; a force history with its "
                                 "noise, or further speeds", model.rows().size(), unknowns - priors));
  return needed;
}

/// The baseline with its damping given by the exact relation, where it is given
/// by a formula that contradicts its own restitution and the data see it.
Hypothesis consistent(const Observations& seen, const Hypothesis& baseline, const HypothesisFit& fit,
                      const SelectionRules& rules) {
  if (baseline.believed.damping_formula.empty()) return baseline;
  Hypothesis exact = baseline;
  exact.effects.push_back({.name = "low-loss-damping-formula", .size = 1.0, .parameters = {}});
  try {
    const HypothesisFit repaired = fit_hypothesis(seen, exact);
    if (repaired.chi_square < fit.chi_square - rules.close_criterion) return exact;
  } catch (const Error& error) {
    if (error.code() != ExitCode::bad_input) throw;  // no such effect for this law
  }
  return baseline;
}

/// Shares of a diagnosis done when its parts end; measured on one that asks FE.
constexpr double baseline_share = 0.05, lumped_share = 0.4, twin_share = 0.7;

void report_progress(const RunControl& whole, double fraction) {
  if (whole.progress) whole.progress(fraction);
}

void search(Diagnosis& d, const DiagnosisRequest& request, const Hypothesis& believed,
            const Observations& all, const RunControl& whole) {
  const RunControl control{.interrupted = whole.interrupted};  // parts do not know the whole
  const auto absent = absent_effects(believed.effects);
  d.believed = judge(*d.seen, fit_hypothesis(*d.seen, believed, control), absent, request.rules,
                     request.seed);
  report_progress(whole, baseline_share);
  Hypothesis baseline = consistent(*d.seen, believed, d.believed.fit, request.rules);
  d.selection = select_effects(*d.seen, baseline, absent_effects(baseline.effects), request.rules,
                               request.seed, control);
  report_progress(whole, lumped_share);
  const bool has_history = std::any_of(d.seen->shots.begin(), d.seen->shots.end(),
                                       [](const ObservedShot& s) { return s.history.has_value(); });
  if (d.selection.baseline.adequate || !d.selection.confusable.empty()) return;
  if (!request.ask_fem || !has_modules() || !has_history) return;

  const auto gap = std::make_shared<const TierGap>(
      measure_tier_gap(all, *d.seen, d.selection.baseline.fit, control));
  report_progress(whole, twin_share);
  const auto seen =
      std::make_shared<const Observations>(with_numerical_uncertainty(*d.seen, *gap));
  baseline.tier_gap = gap;
  EffectSelection with_gap = select_effects(*seen, baseline, absent_effects(baseline.effects),
                                      request.rules, request.seed, control);
  if (!with_gap.baseline.adequate && with_gap.confusable.empty()) return;
  Hypothesis believed_with_gap = believed;
  believed_with_gap.tier_gap = gap;
  d.believed = judge(*seen, fit_hypothesis(*seen, believed_with_gap, control), absent,
                     request.rules, request.seed);
  d.selection = std::move(with_gap);
  d.tier_gap = gap;
  d.seen = seen;
  d.unseen = std::make_shared<const Observations>(with_numerical_uncertainty(*d.unseen, *gap));
  d.warnings.push_back(fmt::format(
      "the data follow a body of finite size: what FE adds to the lumped model (waves, finite "
      "strain) was taken into account, with {:.2g} % of the peak force as its numerical uncertainty",
      100.0 * gap->numerical_uncertainty));
}

}  // namespace

std::string name_of(DiagnosisVerdict verdict) {
  switch (verdict) {
    case DiagnosisVerdict::agrees: return "agrees";
    case DiagnosisVerdict::missing: return "missing";
    case DiagnosisVerdict::one_of: return "one-of";
    case DiagnosisVerdict::unexplained: return "unexplained";
    case DiagnosisVerdict::measurement_fault: return "measurement-fault";
    case DiagnosisVerdict::insufficient_data: return "insufficient-data";
  }
  return {};
}

Diagnosis diagnose(const DiagnosisRequest& request, const RunControl& control) {
  Diagnosis d;
  d.seed = request.seed;
  const Observations all = observe(request.datasets);
  d.warnings = all.warnings;
  d.held_out_speed = choose_held_out(request, all);
  std::vector<bool> fitted, left_out;
  for (const auto& shot : all.shots) {
    left_out.push_back(d.held_out_speed && shot.speed == *d.held_out_speed);
    fitted.push_back(!left_out.back());
  }
  d.seen = std::make_shared<const Observations>(subset(all, fitted));
  d.unseen = std::make_shared<const Observations>(subset(all, left_out));
  if (!d.held_out_speed && request.hold_out)
    d.warnings.push_back("fewer than three speeds: none could be left out to test the extended model");

  d.believed_effects = request.believed_effects.size();
  const Hypothesis baseline{.believed = request.believed, .effects = request.believed_effects,
                            .tier_gap = nullptr};
  d.needed = lacking(*d.seen, baseline);
  if (!d.needed.empty()) return d;

  search(d, request, baseline, all, control);
  withdraw_what_cannot_fail(d);
  locate(d);
  d.gap.before = d.believed.fit.reduced_chi_square();
  const bool explained = d.selection.baseline.adequate || !d.selection.confusable.empty();
  const bool extended = d.best().effects.size() > d.believed_effects;
  if (explained && !extended) {
    conclude_agreement(d);
  } else if (explained) {
    conclude_from_candidates(d);
  } else {
    d.verdict = DiagnosisVerdict::unexplained;
    for (std::size_t k = d.believed_effects; k < d.best().effects.size(); ++k)
      d.effects.push_back(named(d.best(), k));
  }
  if (extended) d.gap.after = d.best().reduced_chi_square();
  if (d.held_out_speed) {
    d.unseen_before = predict_unseen(*d.unseen, d.believed.fit);
    d.gap.held_out_before = d.unseen_before->reduced_chi_square;
    if (d.gap.after) {
      d.unseen_after = predict_unseen(*d.unseen, d.best());
      d.gap.held_out_after = d.unseen_after->reduced_chi_square;
    }
  }
  return d;
}

}  // namespace rebound
