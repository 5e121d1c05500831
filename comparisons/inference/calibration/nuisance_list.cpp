#include <algorithm>

#include "comparisons/inference/calibration/nuisances.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

double gain_over_sigma(const DatumWithSensitivities& datum, const MeasurementChain& chain) {
  return (1.0 + chain.force_gain) / datum.sigma;
}

double largest_noise(const Observations& seen) {
  double noise = 0.0;
  for (const MeasuredImpact& shot : seen.shots)
    if (shot.has_history()) noise = std::max(noise, shot.noise.deviation);
  return noise;
}

NuisanceKind gain_error() {
  return {.name = "gain",
          .unit = "",
          .error = &MeasurementChain::force_gain,
          .slope = [](const DatumWithSensitivities& datum, double,
                      const MeasurementChain&) { return datum.force / datum.sigma; },
          .asked = {.sentence = "Standard deviation of the force gain, as a share.",
                    .range = from_to(0.0, 1.0),
                    .scope = NuisanceScope::all_shots,
                    .label = "gain",
                    .error_of = [](double factor) { return factor - 1.0; },
                    .slope_of = [](double) { return 1.0; }},
          .stated = {.scope = NuisanceScope::all_shots,
                     .label = "force gain",
                     .deviation = [](const Observations& seen, std::size_t) {
                       return largest_noise(seen) > 0.0 ? seen.gain_uncertainty : 0.0;
                     }}};
}

/// A joint fit finds the start of every record without a prior, from its rise.
NuisanceKind trigger_error() {
  return {.name = "trigger",
          .unit = "s",
          .error = &MeasurementChain::trigger_shift,
          .slope =
              [](const DatumWithSensitivities& datum, double, const MeasurementChain& chain) {
                return -gain_over_sigma(datum, chain) * datum.rate;
              },
          .asked = {.sentence = "Standard deviation of the delay of a record; force-time only.",
                    .shown_unit = "us",
                    .range = at_least(0.0),
                    .label = "trigger",
                    .over_time_only = true}};
}

NuisanceKind baseline_error() {
  return {.name = "baseline",
          .unit = "N",
          .error = &MeasurementChain::force_baseline,
          .slope = [](const DatumWithSensitivities& datum, double,
                      const MeasurementChain&) { return 1.0 / datum.sigma; },
          .asked = {.sentence = "Standard deviation of a record's force offset.",
                    .shown_unit = "N",
                    .range = at_least(0.0),
                    .label = "baseline"},
          .stated = {.scope = NuisanceScope::all_shots,
                     .label = "force baseline",
                     .deviation = [](const Observations& seen, std::size_t) {
                       return largest_noise(seen);
                     }}};
}

/// Noise with power at low frequencies moves the zero from shot to shot, and the quiet of one
/// record is too short to show it: as much as the noise itself may be left of it.
NuisanceKind wander_error() {
  return {.name = "wander",
          .unit = "N",
          .error = &MeasurementChain::force_baseline,
          .slope = [](const DatumWithSensitivities& datum, double,
                      const MeasurementChain&) { return 1.0 / datum.sigma; },
          .asked = {.label = "wander of the zero"},
          .stated = {.scope = NuisanceScope::each_shot,
                     .label = "wander of the zero",
                     .deviation = [](const Observations& seen, std::size_t shot) {
                       const ForceNoise& noise = seen.shots[shot].noise;
                       return noise.autocorrelation.empty() ? 0.0 : noise.deviation;
                     }}};
}

/// Reported speed = (1 + ε) true speed.
NuisanceKind speed_error() {
  return {.name = "speed",
          .unit = "",
          .error = &MeasurementChain::speed_error,
          .moves = Direction::Of::speed,
          .slope =
              [](const DatumWithSensitivities& datum, double moved, const MeasurementChain& chain) {
                const double share = 1.0 + chain.speed_error;
                return -gain_over_sigma(datum, chain) * datum.speed * moved / (share * share);
              },
          .asked = {.sentence = "Standard deviation of a stated speed, as a share.",
                    .range = from_to(0.0, 0.5),
                    .label = "speed factor",
                    .error_of = [](double factor) { return 1.0 / factor - 1.0; },
                    .slope_of = [](double error) { return -(1.0 + error) * (1.0 + error); }},
          .stated = {.scope = NuisanceScope::each_shot,
                     .label = "speed error",
                     .deviation = [](const Observations& seen, std::size_t shot) {
                       const MeasuredImpact& one = seen.shots[shot];
                       return one.speed_uncertainty.value_or(0.0) / one.impact.speed;
                     }}};
}

/// Reported mass = (1 + ε) true mass.
NuisanceKind mass_error() {
  return {.name = "mass",
          .unit = "",
          .error = &MeasurementChain::mass_error,
          .moves = Direction::Of::mass,
          .slope =
              [](const DatumWithSensitivities& datum, double moved, const MeasurementChain& chain) {
                const double share = 1.0 + chain.mass_error;
                return -gain_over_sigma(datum, chain) * datum.mass * moved / (share * share);
              },
          .asked = {.label = "mass error"},
          .stated = {.scope = NuisanceScope::each_ball,
                     .label = "mass error",
                     .deviation = [](const Observations& seen, std::size_t ball) {
                       return seen.balls[ball].mass_uncertainty / seen.balls[ball].sphere.mass;
                     }}};
}

/// Nothing in a force moves with it.
double no_slope(const DatumWithSensitivities&, double, const MeasurementChain&) {
  return 0.0;
}

bool has_deflection(const MeasuredImpact& shot) {
  return shot.deflection_noise.deviation > 0.0;
}

NuisanceKind deflection_gain_error() {
  return {.name = "deflection-gain",
          .unit = "",
          .error = &MeasurementChain::deflection_gain,
          .slope = no_slope,
          .asked = {.label = "deflection gain"},
          .stated = {.scope = NuisanceScope::all_shots,
                     .label = "deflection gain",
                     .deviation = [](const Observations& seen, std::size_t) {
                       const bool any =
                           std::any_of(seen.shots.begin(), seen.shots.end(), has_deflection);
                       return any ? seen.deflection_gain_uncertainty : 0.0;
                     }}};
}

/// The instant of first touch, by which a deflection is set to zero, is read off the record.
NuisanceKind deflection_zero_error() {
  constexpr double of_largest = 0.02;
  return {.name = "deflection-zero",
          .unit = "m",
          .error = &MeasurementChain::deflection_zero,
          .slope = no_slope,
          .asked = {.label = "zero of the deflection"},
          .stated = {.scope = NuisanceScope::each_shot,
                     .label = "zero of the deflection",
                     .deviation = [](const Observations& seen, std::size_t shot) {
                       const MeasuredImpact& one = seen.shots[shot];
                       if (!has_deflection(one)) return 0.0;
                       const auto& x = one.trace.deflection;
                       return of_largest * *std::max_element(x.begin(), x.end());
                     }}};
}

}  // namespace

const std::vector<NuisanceKind>& all_nuisances() {
  static const std::vector<NuisanceKind> list = {
      gain_error(),  trigger_error(), baseline_error(),        wander_error(),
      speed_error(), mass_error(),    deflection_gain_error(), deflection_zero_error()};
  return list;
}

const NuisanceKind& find_nuisance(const std::string& name) {
  const auto& list = all_nuisances();
  const auto found = std::find_if(list.begin(), list.end(),
                                  [&](const NuisanceKind& kind) { return kind.name == name; });
  if (found == list.end())
    throw Error(ExitCode::bad_input, "there is no nuisance of this name", {.key = name});
  return *found;
}

}  // namespace rebound
