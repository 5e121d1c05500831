#include "comparisons/inference/calibration/nuisances.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace rebound {
namespace {

/// An unknown about the mean of its prior, bounded at `reach` standard deviations of its prior.
CalibrationParameter unknown_about(const std::string& name, const std::string& unit,
                                   const Prior& prior, double reach) {
  return {.name = name,
          .unit = unit,
          .start = prior.mean,
          .lowest = prior.mean - reach * prior.deviation,
          .highest = prior.mean + reach * prior.deviation,
          .scale = prior.deviation,
          .prior = prior};
}

std::vector<std::size_t> shots_of_ball(const Observations& seen, std::size_t ball) {
  std::vector<std::size_t> shots;
  for (std::size_t i = 0; i < seen.shots.size(); ++i)
    if (seen.shots[i].ball == ball) shots.push_back(i);
  return shots;
}

constexpr double anything = 1e3;  // a bound that is none: the prior holds what data state

}  // namespace

double Nuisances::of(const std::string& name) const {
  const auto found = deviation.find(name);
  return found == deviation.end() ? 0.0 : found->second;
}

bool Nuisances::any() const {
  return std::any_of(deviation.begin(), deviation.end(),
                     [](const auto& one) { return one.second > 0.0; });
}

std::size_t NuisanceUnknowns::add(const NuisanceKind& kind, const CalibrationParameter& unknown,
                                  const std::vector<std::size_t>& shots,
                                  std::vector<CalibrationParameter>& unknowns) {
  const std::size_t place = unknowns.size();
  for (const std::size_t shot : shots)
    places_[shot].push_back({.kind = &kind, .unknown = place, .is_factor = false});
  unknowns.push_back(unknown);
  return place;
}

void NuisanceUnknowns::add_asked(const Nuisances& asked,
                                 std::vector<CalibrationParameter>& unknowns) {
  for (const auto& [name, deviation] : asked.deviation) find_nuisance(name);
  constexpr double reach = 6.0;
  std::vector<std::size_t> all(places_.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  for (const NuisanceKind& kind : all_nuisances()) {
    const double deviation = asked.of(kind.name);
    if (!(deviation > 0.0)) continue;
    const bool is_factor = kind.asked.error_of != nullptr;
    const Prior prior{is_factor ? 1.0 : 0.0, deviation};
    const auto add_for = [&](const std::string& name, const std::vector<std::size_t>& shots) {
      add(kind, unknown_about(name, kind.unit, prior, reach), shots, unknowns);
      for (const std::size_t shot : shots) places_[shot].back().is_factor = is_factor;
    };
    if (kind.asked.scope == NuisanceScope::all_shots) {
      add_for(kind.asked.label, all);
    } else {
      for (const std::size_t shot : all)
        add_for(fmt::format("{} of shot {}", kind.asked.label, shot + 1), {shot});
    }
  }
}

void NuisanceUnknowns::add_stated(const Observations& seen,
                                  std::vector<CalibrationParameter>& unknowns) {
  std::vector<std::size_t> all(places_.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const auto add_scope = [&](NuisanceScope scope, std::size_t index,
                             const std::vector<std::size_t>& shots, const std::string& of) {
    for (const NuisanceKind& kind : all_nuisances()) {
      if (!kind.stated.deviation || kind.stated.scope != scope) continue;
      const double deviation = kind.stated.deviation(seen, index);
      if (deviation > 0.0)
        add(kind, unknown_about(kind.stated.label + of, kind.unit, {0.0, deviation}, anything),
            shots, unknowns);
    }
  };
  add_scope(NuisanceScope::all_shots, 0, all, "");
  for (std::size_t ball = 0; ball < seen.balls.size(); ++ball)
    add_scope(NuisanceScope::each_ball, ball, shots_of_ball(seen, ball),
              " of " + seen.balls[ball].name);
}

void NuisanceUnknowns::add_stated_of_shot(const Observations& seen, std::size_t shot,
                                          std::vector<CalibrationParameter>& unknowns) {
  for (const NuisanceKind& kind : all_nuisances()) {
    if (!kind.stated.deviation || kind.stated.scope != NuisanceScope::each_shot) continue;
    const double deviation = kind.stated.deviation(seen, shot);
    if (!(deviation > 0.0)) continue;
    of_shots_.push_back(add(kind,
                            unknown_about(kind.stated.label + ", " + seen.shots[shot].label,
                                          kind.unit, {0.0, deviation}, anything),
                            {shot}, unknowns));
  }
}

void NuisanceUnknowns::apply(const std::vector<double>& x, std::size_t shot,
                             MeasurementChain& chain) const {
  for (const auto& [kind, unknown, is_factor] : places_[shot])
    chain.*kind->error += is_factor ? kind->asked.error_of(x[unknown]) : x[unknown];
}

}  // namespace rebound
