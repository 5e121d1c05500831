#include "comparisons/discrepancy/diagnosis/search/effect_grid.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "comparisons/io/dataset/contact_window.hpp"
#include "lumped/problem/scalars.hpp"

namespace rebound {
namespace {

constexpr double size_step = 0.05;             // of the prior scale
constexpr double smallest_tried = 1.0 / 64.0;  // of it: plates are stiff by orders of magnitude

/// What a rig is known by: its records.
struct RecordScales {
  double contact = 0.0;  ///< shortest contact [s]
  double record = 0.0;   ///< longest record [s]
  double step = 0.0;     ///< longest between two samples [s]
  double largest = 0.0;  ///< reading [N]
};

RecordScales scales_of(const Observations& seen) {
  RecordScales scales;
  for (const MeasuredImpact& shot : seen.shots) {
    if (!shot.has_history()) continue;
    const auto& [time, force] = std::tie(shot.trace.time, shot.trace.force);
    const double peak = *std::max_element(force.begin(), force.end());
    const double contact = time_above(shot.trace, clearly_in_contact * peak);
    const double length = time.back() - time.front();
    scales.contact = scales.contact == 0.0 ? contact : std::min(scales.contact, contact);
    scales.record = std::max(scales.record, length);
    scales.step = std::max(scales.step, length / static_cast<double>(time.size() - 1));
    scales.largest = std::max(scales.largest, peak);
  }
  return scales;
}

/// SI of what one is in `unit`; zero where no record says it.
double unit_of(TriedIn unit, const RecordScales& scales) {
  switch (unit) {
    case TriedIn::si: return 1.0;
    case TriedIn::contact_times: return scales.contact;
    case TriedIn::per_contact_time: return scales.contact > 0.0 ? 1.0 / scales.contact : 0.0;
    case TriedIn::largest_readings: return scales.largest;
  }
  return 0.0;
}

/// Numbers of a card within its range, SI; empty where no record says what they are shares of.
std::vector<double> in_si(const std::vector<double>& tried, TriedIn unit, const Range& range,
                          const RecordScales& scales) {
  const double one = unit_of(unit, scales);
  std::vector<double> values;
  if (!(one > 0.0)) return values;
  for (const double value : tried)
    values.push_back(std::clamp(value * one, range.lowest, range.highest));
  return values;
}

/// The numbers of one parameter that are tried; empty: it stays as it is.
std::vector<double> tried_values(const EffectParameterCard& parameter, const Observations& seen,
                                 const RecordScales& scales) {
  std::vector<double> values;
  if (parameter.kind == ParameterKind::shot) {
    for (const MeasuredImpact& shot : seen.shots)
      if (shot.number > 0) values.push_back(shot.number);
    return values;
  }
  if (makes_variants(parameter)) {
    values = parameter.tried;
    if (parameter.is_left_open) values.insert(values.begin(), parameter.default_value);
    return values;
  }
  if (!parameter.fitted || parameter.is_left_open) return values;
  values = in_si(parameter.tried, parameter.tried_in, parameter.range, scales);
  if (!values.empty()) return values;
  if (parameter.kind == ParameterKind::linear) return {parameter.default_value};
  for (const double factor : {0.1, 0.3, 1.0, 3.0, 10.0})
    values.push_back(std::clamp(factor * parameter.default_value, parameter.range.lowest,
                                parameter.range.highest));
  return values;
}

/// Frequencies that histories can show, from a third of a swing in a contact on [Hz].
std::vector<double> frequencies(const OscillatorCard& oscillator, const Observations& seen,
                                GridDetail detail) {
  constexpr double fewest_swings = 0.35, most_swings = 8.0, most_rings = 40.0;  // in a contact
  constexpr double line_width = 0.02;  // of a frequency, with a damping ratio of one per cent
  constexpr double coarse = 1.3;       // from one to the next
  const RecordScales scales = scales_of(seen);
  if (!(scales.contact > 0.0)) return {};
  const double seen_for = oscillator.rings_on ? scales.record : scales.contact;
  const double highest = std::min((oscillator.rings_on ? most_rings : most_swings) / scales.contact,
                                  0.35 / scales.step);
  std::vector<double> all;
  for (double f = fewest_swings / scales.contact; f <= highest;) {
    all.push_back(f);
    f = detail == GridDetail::coarse ? coarse * f : f + std::max(0.5 / seen_for, line_width * f);
  }
  return all;
}

}  // namespace

std::vector<EffectChoice> with_each(const std::vector<EffectChoice>& all,
                                    const std::string& parameter,
                                    const std::vector<double>& values) {
  std::vector<EffectChoice> combined;
  for (const EffectChoice& one : all)
    for (const double value : values) {
      combined.push_back(one);
      combined.back().parameters[parameter] = value;
    }
  return combined;
}

std::vector<EffectChoice> over_parameters(const EffectCard& card, const EffectChoice& effect,
                                          const Observations& seen) {
  std::vector<EffectChoice> all{effect};
  const RecordScales scales = scales_of(seen);
  for (const auto& parameter : card.parameters) {
    const std::vector<double> values = tried_values(parameter, seen, scales);
    if (!values.empty()) all = with_each(all, parameter.name, values);
  }
  return all;
}

std::vector<EffectChoice> small_effects(const EffectCard& card, const Observations& seen,
                                        GridDetail detail) {
  constexpr double slight = 0.01;
  if (card.oscillator) {
    std::vector<EffectChoice> all;
    for (const double frequency : frequencies(*card.oscillator, seen, detail))
      all.push_back(card.oscillator->with(frequency, slight, seen.shots.front().sphere.mass));
    if (!all.empty()) return all;
  }
  std::vector<double> sizes = in_si(card.tried, card.tried_in, card.range, scales_of(seen));
  if (sizes.empty() && (card.is_switch || !std::isfinite(card.null))) {
    sizes = {card.is_switch ? 1.0 : card.prior_scale};
  } else if (sizes.empty()) {
    const double step = size_step * card.prior_scale;
    sizes = {card.null + step <= card.range.highest ? card.null + step : card.null - step};
  }
  std::vector<EffectChoice> all;
  for (const double size : sizes)
    for (auto& choice : over_parameters(card, {card.name, size, {}}, seen)) all.push_back(choice);
  return all;
}

std::vector<EffectChoice> stronger_effects(const OscillatorCard& card, const EffectChoice& small,
                                           const Observations& seen) {
  std::vector<EffectChoice> all;
  for (const double strength : {0.005, 0.02, 0.08, 0.3})
    all.push_back(card.with(card.frequency_of(small), strength, seen.shots.front().sphere.mass));
  return all;
}

std::vector<EffectChoice> finite_effects(const EffectCard& card, const Observations& seen,
                                         GridDetail detail) {
  std::vector<EffectChoice> all;
  const auto add = [&](double size) {
    if (size < card.range.lowest || size > card.range.highest) return;
    for (auto& choice : over_parameters(card, {card.name, size, {}}, seen)) all.push_back(choice);
  };
  if (card.is_switch) {
    add(1.0);
    return all;
  }
  for (const double size : in_si(card.tried, card.tried_in, card.range, scales_of(seen))) add(size);
  if (!card.tried.empty()) return all;
  const double null = std::isfinite(card.null) ? card.null : 0.0;
  // A fine grid of the parameters needs no fine one of the size beside it.
  const bool many = detail == GridDetail::coarse ||
                    over_parameters(card, {card.name, card.prior_scale, {}}, seen).size() > 10;
  for (double factor = smallest_tried; factor < 8.0; factor *= many ? 4.0 : 2.0) {
    add(null + factor * card.prior_scale);
    add(null - factor * card.prior_scale);
  }
  return all;
}

}  // namespace rebound
