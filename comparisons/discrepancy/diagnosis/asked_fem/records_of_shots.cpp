#include "comparisons/discrepancy/diagnosis/asked_fem/records_of_shots.hpp"

#include <cmath>
#include <limits>

#include "comparisons/discrepancy/diagnosis/fits/record_of_impact.hpp"
#include "comparisons/inference/calibration/search.hpp"
#include "comparisons/inference/calibration/whitening.hpp"
#include "comparisons/models/instrument/reported_force.hpp"

namespace rebound {
namespace {

/// Exponents of the speed in peak force and contact time (Hertz).
constexpr double of_force = 1.2, of_time = -0.2;

/// A change of speed within its uncertainty needs no impact of its own.
ModelledImpact at_other_speed(ModelledImpact impact, double factor) {
  const double force = std::pow(factor, of_force), time = std::pow(factor, of_time);
  for (double& one : impact.trace.force) one *= force;
  for (double& one : impact.trace.time) one *= time;
  return impact;
}

double nearest_first_touch(const Observations& seen, std::size_t shot, const ModelledImpact& impact,
                           const std::vector<EffectChoice>& effects, double gain, double near) {
  constexpr int half_samples = 4;
  const std::vector<std::size_t> alone{shot};
  RecordsOfShots record(seen, alone, gain);
  std::vector<CalibrationParameter> unknowns;
  record.add_unknowns([&](std::size_t) { return near; }, unknowns);
  const std::vector<double>& time = seen.shots[shot].trace.time;
  const auto at_touch = [&](double touch) {
    std::vector<double> values;
    values.reserve(unknowns.size());
    for (const CalibrationParameter& one : unknowns)
      values.push_back(one.unit == "s" ? touch : 0.0);
    return values;
  };
  const double half_a_sample = 0.5 * (time[1] - time[0]);
  double nearest = near, least = std::numeric_limits<double>::infinity();
  for (int k = -half_samples; k <= half_samples; ++k) {
    const double touch = near + k * half_a_sample;
    const double left = half_square(record.residuals(at_touch(touch), {impact}, effects));
    if (left < least) {
      least = left;
      nearest = touch;
    }
  }
  return nearest;
}

}  // namespace

void RecordsOfShots::add_unknowns(const std::function<double(std::size_t shot)>& first_touch,
                                  std::vector<CalibrationParameter>& unknowns) {
  if (!known_gain_) {
    const double deviation = seen_.gain_uncertainty + 1e-4;
    nuisances_.add(find_nuisance("gain"),
                   {.name = "gain",
                    .unit = "1",
                    .start = 0.0,
                    .lowest = -0.5,
                    .highest = 0.5,
                    .scale = deviation,
                    .prior = Prior{0.0, deviation}},
                   shots_, unknowns);
  }
  for (const std::size_t i : shots_) {
    const MeasuredImpact& shot = seen_.shots[i];
    if (const double of_speed = shot.speed_uncertainty.value_or(0.0) / shot.impact.speed;
        of_speed > 0.0)
      nuisances_.add(find_nuisance("speed"),
                     {.name = "speed, " + shot.label,
                      .unit = "1",
                      .start = 0.0,
                      .lowest = -0.2,
                      .highest = 0.2,
                      .scale = of_speed,
                      .prior = Prior{0.0, of_speed}},
                     {i}, unknowns);
    const double first = shot.trace.time.front(), last = shot.trace.time.back();
    nuisances_.add(find_nuisance("trigger"),
                   {.name = "start, " + shot.label,
                    .unit = "s",
                    .start = first_touch(i),
                    .lowest = first - (last - first),
                    .highest = last,
                    .scale = 1e-2 * (last - first)},
                   {i}, unknowns);
  }
}

std::vector<double> RecordsOfShots::residuals(const std::vector<double>& values,
                                              const std::vector<ModelledImpact>& impacts,
                                              const std::vector<EffectChoice>& effects) const {
  std::vector<double> residuals;
  for (std::size_t k = 0; k < shots_.size(); ++k) {
    const MeasuredImpact& shot = seen_.shots[shots_[k]];
    MeasurementChain chain = stated_chain(shot);
    apply_effects(effects, chain);
    nuisances_.apply(values, shots_[k], chain);
    chain.force_gain += known_gain_.value_or(0.0);
    const auto& time = shot.trace.time;
    const ModelledImpact impact = at_other_speed(impacts[k], 1.0 / (1.0 + chain.speed_error));
    const auto r =
        whitened(shot, reported_force(contact_and_after(impact, chain, time), chain, time));
    residuals.insert(residuals.end(), r.begin(), r.end());
    if (const Measured& measured = shot.restitution; measured.has_error())
      residuals.push_back((impacts[k].scalars.restitution - *measured.value) /
                          *measured.uncertainty);
  }
  return residuals;
}

FirstTouches nearest_first_touches(const Observations& seen, const std::vector<std::size_t>& shots,
                                   const std::vector<ModelledImpact>& impacts,
                                   const std::vector<EffectChoice>& effects, double gain,
                                   FirstTouches near) {
  for (std::size_t k = 0; k < shots.size(); ++k)
    near.at(shots[k]) =
        nearest_first_touch(seen, shots[k], impacts[k], effects, gain, near.at(shots[k]));
  return near;
}

}  // namespace rebound
