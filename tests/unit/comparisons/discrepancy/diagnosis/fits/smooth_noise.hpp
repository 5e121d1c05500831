#pragma once

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "comparisons/models/instrument/butterworth.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound::testing {

/// A damper beside the believed law that grows with the root of the root of the deflection, as
/// Tsuji's; 0: a curve that is none.
inline EffectChoice damper_of_slope(double slope) {
  const EffectCard& card = find_effect("damping-curves").card;
  EffectChoice choice{.name = card.name, .size = 0.0, .parameters = {}};
  for (const EffectParameterCard& one : card.parameters)
    choice.parameters[one.name] = one.default_value;
  for (int k = 1; k < 6; ++k)
    choice.parameters["deflection_" + std::to_string(k)] = 0.2 * slope * k;
  return choice;
}

/// Four speeds of a ball with that damper under noise of 10 N that a filter has made smooth; its
/// corner is a share of the sampling rate.
inline Dataset under_smooth_noise(const EffectChoice& damper, double corner, int seed) {
  constexpr double deviation = 10.0;
  constexpr std::size_t settling = 2000;  // samples
  SynthesisFile file = experiment_with({damper}, seed);
  file.instrument.force_noise = 1e-3;
  file.shots = {{.speed = 5.0, .speed_uncertainty = 0.02},
                {.speed = 10.0, .speed_uncertainty = 0.3},
                {.speed = 15.0, .speed_uncertainty = 0.05},
                {.speed = 25.0, .speed_uncertainty = 0.1}};
  Dataset data = measured_data(file);
  data.instrument.force_noise = deviation;
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  std::normal_distribution<double> normal;
  for (auto& shot : data.shots) {
    std::vector<double> noise(shot.trace.force.size() + settling);
    for (double& one : noise) one = normal(random);
    noise = Butterworth({.corner = corner, .sampling_rate = 1.0}).filter(noise);
    double squares = 0.0;
    for (const double one : noise) squares += one * one;
    const double scale = deviation / std::sqrt(squares / static_cast<double>(noise.size()));
    for (std::size_t i = 0; i < shot.trace.force.size(); ++i)
      shot.trace.force[i] += scale * noise[i + settling];
  }
  return data;
}

}  // namespace rebound::testing
