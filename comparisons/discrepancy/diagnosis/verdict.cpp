#include "comparisons/discrepancy/diagnosis/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rebound {
namespace {

NumberWithInterval with_interval(const HypothesisFit& fit, std::size_t unknown,
                                 const std::string& name, bool logarithmic) {
  const Estimate& e = fit.search.estimates[unknown];
  const auto back = [&](double x) { return logarithmic ? std::exp(x) : x; };
  return {.name = name, .value = back(e.value), .low = back(e.low), .high = back(e.high)};
}

NamedEffect named(const HypothesisFit& fit, std::size_t k) {
  const EffectChoice& choice = fit.effects[k];
  const Effect& effect = find_effect(choice.name);
  NamedEffect result{
      .effect = choice,
      .size = {.name = choice.name, .value = choice.size, .low = choice.size, .high = choice.size},
      .parameters = {}};
  if (!effect.to_fem) result.fem = "no-form";
  if (!effect.to_lumped) result.lumped = "no-form";
  const auto& unknowns = fit.model->unknowns_of_effect(k);
  if (unknowns.empty()) return result;
  result.size = with_interval(fit, unknowns[0], choice.name, false);
  std::size_t next = 1;
  for (const auto& parameter : effect.card.parameters)
    if (parameter.fitted)
      result.parameters.push_back(with_interval(fit, unknowns[next++], parameter.name,
                                                parameter.kind == ParameterKind::logarithmic));
    else if (parameter.kind == ParameterKind::shot) {
      const double shot = choice.parameters.at(parameter.name);
      result.parameters.push_back({parameter.name, shot, shot, shot});
    }
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

void conclude_from_candidates(Diagnosis& d, const SelectionRules& rules) {
  std::vector<const HypothesisFit*> fits;
  for (const std::size_t i : d.selection.indistinguishable)
    fits.push_back(&d.selection.tried[i].fit);
  if (fits.empty()) fits.push_back(&d.selection.baseline.fit);  // set right by its formula alone
  for (const auto* fit : fits) d.candidates.push_back(added_effects(d, *fit));
  const auto in_all = [&](const std::string& name) {
    return std::all_of(d.candidates.begin(), d.candidates.end(), [&](const auto& names) {
      return std::find(names.begin(), names.end(), name) != names.end();
    });
  };
  for (std::size_t k = d.believed_effects; k < fits.front()->effects.size(); ++k)
    if (in_all(fits.front()->effects[k].name)) d.effects.push_back(named(*fits.front(), k));
  const bool only_measurement = std::all_of(
      d.candidates.begin(), d.candidates.end(),
      [](const auto& names) { return std::all_of(names.begin(), names.end(), is_measurement); });
  if (only_measurement) {
    d.verdict = DiagnosisVerdict::measurement_fault;
    for (const auto* fit : fits)
      d.fault += (d.fault.empty() ? "" : " or ") + label_of(fit->effects);
  } else {
    d.verdict = fits.size() == 1 ? DiagnosisVerdict::missing : DiagnosisVerdict::one_of;
  }
  if (fits.size() > 1) d.next = next_experiments(*d.seen, fits, rules.close_criterion);
}

/// Data that are left to contradict a fit: less what was fitted, and less the
/// restitutions that a damping formula was given.
int contradicting_data(const Observations& seen, const HypothesisFit& fit) {
  int inputs = 0;
  if (!fit.hypothesis.believed.damping_formula.empty())
    for (const MeasuredImpact& shot : seen.shots) inputs += shot.restitution.value ? 1 : 0;
  const auto priors = static_cast<int>(fit.residuals.size() - fit.data_rows());
  return static_cast<int>(fit.data_rows()) - inputs -
         (static_cast<int>(fit.values.size()) - priors);
}

/// A single set that fits because nothing was left to contradict it carries no name.
void withdraw_what_cannot_fail(Diagnosis& d) {
  if (d.selection.indistinguishable.size() != 1) return;
  const HypothesisFit& fit = d.best();
  if (contradicting_data(*d.seen, fit) > 0) return;
  d.needed.push_back(fmt::format(
      "data that could contradict it: {} fits what is left, but with as many numbers as there are "
      "data; force histories, or further speeds",
      label_of(fit.effects)));
  d.selection.indistinguishable.clear();
}

void conclude_agreement(Diagnosis& d) {
  d.verdict = DiagnosisVerdict::agrees;
  constexpr double one_sided = 1.645;  // 95 % of a normal
  for (const EffectScore& score : d.selection.scores) {
    const EffectCard& card = find_effect(score.name).card;
    if (card.is_switch || !std::isfinite(card.null)) continue;
    const double reach = std::abs(score.size) + one_sided * score.size_error;
    if (reach < card.range.highest) d.excluded.push_back({score.name, reach});
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

void conclude(Diagnosis& d, const SelectionRules& rules) {
  withdraw_what_cannot_fail(d);
  locate(d);
  if (!d.selection.explains()) {
    d.verdict = DiagnosisVerdict::unexplained;
    for (std::size_t k = d.believed_effects; k < d.best().effects.size(); ++k)
      d.effects.push_back(named(d.best(), k));
  } else if (d.extended()) {
    conclude_from_candidates(d, rules);
  } else {
    conclude_agreement(d);
  }
}

}  // namespace rebound
