#pragma once

#include <string>

#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"
#include "comparisons/discrepancy/synthesis/synthesize.hpp"

namespace rebound::testing {

/// Three speeds, Hunt–Crossley, an honest instrument; effects are added by the test.
inline SynthesisFile experiment_with(std::vector<EffectChoice> effects, std::int64_t seed) {
  SynthesisFile file;
  file.seed = seed;
  file.sphere = {.mass = 89.6e-3, .diameter = 66.2e-3};
  file.mass_uncertainty = 1e-4;
  file.lumped.parameters = {{"exponent", 1.5}, {"stiffness", 3.2e6}, {"damping", 7e4}};
  file.effects = std::move(effects);
  file.instrument.force_noise = 20.0;
  file.instrument.force_gain_uncertainty = 0.01;
  file.shots = {{.speed = 5.0, .speed_uncertainty = 0.02},
                {.speed = 15.0, .speed_uncertainty = 0.05},
                {.speed = 25.0, .speed_uncertainty = 0.1}};
  return file;
}

/// The same with few samples: a diagnosis takes a third of a second.
inline SynthesisFile coarse_experiment(std::int64_t seed) {
  SynthesisFile file = experiment_with({}, seed);
  file.sampling.rate = 40e3;
  return file;
}

/// Three shots at each of the three speeds: what one shot alone does is not taken for its speed.
inline SynthesisFile three_times_each_speed(std::vector<EffectChoice> effects, std::int64_t seed) {
  SynthesisFile file = experiment_with(std::move(effects), seed);
  const auto once = file.shots;
  for (int repeat = 0; repeat < 2; ++repeat)
    file.shots.insert(file.shots.end(), once.begin(), once.end());
  return file;
}

/// What somebody believes: the same law, other numbers, no effect.
inline LumpedModel believed_law() {
  LumpedModel model;
  model.parameters = {{"exponent", 1.5}, {"stiffness", 3.5e6}, {"damping", 8e4}};
  return model;
}

/// What is measured on what the file describes.
inline Dataset measured_data(const SynthesisFile& file) {
  return synthesize(file, simulator_of(file, {})).dataset;
}

inline Diagnosis diagnosis_of(const Dataset& dataset, const LumpedModel& believed = believed_law(),
                              const SelectionRules& rules = {}) {
  DiagnosisRequest request{.rules = rules};
  request.datasets = {dataset};
  request.believed = believed;
  request.ask_fem = false;
  return diagnose(request);
}

inline Diagnosis diagnose_hidden(const SynthesisFile& file, const SelectionRules& rules = {}) {
  return diagnosis_of(measured_data(file), believed_law(), rules);
}

}  // namespace rebound::testing
