#include "comparisons/discrepancy/diagnosis/verdict/named_effect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "comparisons/inference/calibration/effective_residuals.hpp"
#include "comparisons/inference/calibration/profile.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"

namespace rebound {
namespace {

NumberWithInterval with_interval(const HypothesisFit& fit, std::size_t unknown,
                                 const std::string& name, bool logarithmic) {
  const Estimate& e = fit.search.estimates[unknown];
  const auto back = [&](double x) { return logarithmic ? std::exp(x) : x; };
  return {.name = name, .value = back(e.value), .low = back(e.low), .high = back(e.high)};
}

/// A number that is free but looked for at one value only, such as a damping ratio: data need not
/// determine it for its effect to have a name.
bool is_secondary(const EffectCard& card, const std::string& unknown) {
  return std::any_of(card.parameters.begin(), card.parameters.end(),
                     [&](const EffectParameterCard& one) {
                       return card.name + " " + one.name == unknown && one.tried.size() == 1;
                     });
}

bool leaves_out_null(const EffectCard& card, const NumberWithInterval& size) {
  constexpr double a_little_more = 1.1;  // than searches keep off
  const double slack = a_little_more * share_next_to_null(card) *
                       (has_logarithmic_size(card) ? size.value : card.prior_scale);
  return !std::isfinite(card.null) || size.low - slack > card.null || size.high + slack < card.null;
}

/// Do the linearised intervals of effect k say enough?
bool is_well_determined(const HypothesisFit& fit, std::size_t k, const NumberWithInterval& size,
                        std::size_t place) {
  std::vector<std::size_t> unknowns = fit.model->unknowns_of_effect(k);
  // Of the sizes the one in question.
  std::swap(unknowns[0], unknowns[place]);
  unknowns.erase(unknowns.begin() + 1,
                 unknowns.begin() + static_cast<std::ptrdiff_t>(fit.model->sizes_of_effect(k)));
  return leaves_out_null(find_effect(fit.effects[k].name).card, size) &&
         std::all_of(unknowns.begin(), unknowns.end(), [&](std::size_t unknown) {
           return fit.search.estimates[unknown].identifiability !=
                  Identifiability::not_identifiable;
         });
}

/// Likelihood-ratio interval of the size, all else refitted: where two numbers of an effect trade
/// against each other, as mass and stiffness of a plate do, the linearised one is too narrow.
ProfileInterval profile_of_size(const HypothesisFit& fit, std::size_t k, std::size_t place) {
  const auto problem_of = [](const JointModel& model) {
    CalibrationProblem problem = with_priors(model.problem());
    problem.controls.cost_tolerance = 1e-6;
    problem.controls.iterations = 30;
    return problem;
  };
  const JointModel below = *fit.model, above = *fit.model;  // a thread each
  return profile_of(problem_of(below), problem_of(above), fit.search,
                    fit.model->unknowns_of_effect(k)[place], {});
}

/// A number of effect k that a search left at its bound; empty: none.
std::string number_at_bound(const HypothesisFit& fit, std::size_t k) {
  const EffectCard& card = find_effect(fit.effects[k].name).card;
  for (const std::size_t unknown : fit.model->unknowns_of_effect(k)) {
    const Estimate& estimate = fit.search.estimates[unknown];
    if (!is_secondary(card, estimate.name) && estimate.identifiability == Identifiability::at_bound)
      return estimate.name + " is at a bound of the search";
  }
  return {};
}

/// A size of effect k with the interval that the data give it; `weak` says why it carries no name.
NumberWithInterval measure_size(const HypothesisFit& fit, std::size_t k, std::size_t place,
                                std::string& weak) {
  const EffectCard& card = find_effect(fit.effects[k].name).card;
  const bool logarithmic = has_logarithmic_size(card);
  NumberWithInterval size =
      with_interval(fit, fit.model->unknowns_of_effect(k)[place], card.name, logarithmic);
  if (card.is_free_form) return size;  // its curve has a band
  weak = number_at_bound(fit, k);
  // In finite elements a profile takes minutes. Beside a force that jumps at first touch it is too
  // narrow: a search ends wherever a sample more would have to be met by the jump.
  const bool linearised = fit.model->fem() || card.jumps_at_touch;
  if (linearised && is_well_determined(fit, k, size, place)) return size;
  const ProfileInterval profile = profile_of_size(fit, k, place);
  size.low = logarithmic ? std::exp(profile.low) : profile.low;
  size.high = logarithmic ? std::exp(profile.high) : profile.high;
  // What rings on is known by its frequency: a load cell reads the same ringing however heavy the
  // plate is, so that compliance may be unbounded below where the plate is certain.
  const bool known_by_frequency = card.oscillator && card.oscillator->rings_on;
  if (!weak.empty() || known_by_frequency) return size;
  if (!profile.low_closed || !profile.high_closed)
    weak = fmt::format("the data do not bound its size of {:.3g} within [{:.3g}, {:.3g}]",
                       size.value, size.low, size.high);
  else if (!leaves_out_null(card, size))
    weak = fmt::format("the size {:.3g} [{:.3g}, {:.3g}] may as well be that of no effect",
                       size.value, size.low, size.high);
  return size;
}

/// Sizes of effect k. Of several balls one is enough to carry the name: another may be without it.
void measure_sizes(const HypothesisFit& fit, std::size_t k, NamedEffect& result) {
  const std::size_t sizes = fit.model->sizes_of_effect(k);
  bool carried = false;
  for (std::size_t place = 0; place < sizes; ++place) {
    std::string weak;
    const NumberWithInterval size = measure_size(fit, k, place, weak);
    if (place == 0) result.size = size;
    if (sizes > 1) result.size_of_balls.push_back(size);
    carried = carried || weak.empty();
    if (result.weak.empty()) result.weak = weak;
  }
  if (carried) result.weak.clear();
}

}  // namespace

std::vector<NamedEffect> named_effects(const HypothesisFit& fit, std::size_t known) {
  std::vector<NamedEffect> effects(fit.effects.size() - known);
  in_parallel(effects.size(), [&](std::size_t i) { effects[i] = named_effect(fit, known + i); });
  return effects;
}

NamedEffect named_effect(const HypothesisFit& fit, std::size_t k) {
  const EffectChoice& choice = fit.effects[k];
  const Effect& effect = find_effect(choice.name);
  NamedEffect result{
      .effect = choice,
      .size = {.name = choice.name, .value = choice.size, .low = choice.size, .high = choice.size},
      .parameters = {}};
  if (fit.model->fem()) std::swap(result.lumped, result.fem);  // the tier that was run
  if (!effect.to_fem) result.fem = "no-form";
  if (!effect.to_lumped) result.lumped = "no-form";
  const auto& unknowns = fit.model->unknowns_of_effect(k);
  if (unknowns.empty()) return result;
  measure_sizes(fit, k, result);
  std::size_t next = fit.model->sizes_of_effect(k);
  for (const auto& parameter : effect.card.parameters)
    if (is_unknown(parameter, fit.model->fem() != nullptr, choice))
      result.parameters.push_back(with_interval(fit, unknowns[next++], parameter.name,
                                                parameter.kind == ParameterKind::logarithmic));
    else if (parameter.kind == ParameterKind::shot) {
      const double shot = choice.parameters.at(parameter.name);
      result.parameters.push_back({parameter.name, shot, shot, shot});
    }
  return result;
}

}  // namespace rebound
