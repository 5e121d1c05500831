#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "comparisons/discrepancy/trials/trial_controls.hpp"
#include "comparisons/discrepancy/trials/trial_run.hpp"
#include "comparisons/discrepancy/trials/trial_score.hpp"

/// Trials as they would stand after a run, made by hand.
namespace rebound::testing {

inline TrialTruth nothing_hidden(int trial) {
  TrialTruth truth;
  truth.set = "example";
  truth.seed = 7;
  truth.trial = trial;
  truth.noise_colour = "white";
  truth.noise_stated = "right";
  truth.noise_share = 0.01;
  return truth;
}

inline TrialTruth hidden(int trial, const std::string& family, const std::string& name,
                         double visible = 100.0) {
  TrialTruth truth = nothing_hidden(trial);
  truth.visible_chi_square = visible;
  TrialEffect effect;
  effect.family = family;
  effect.form = "some-" + name;
  effect.registry_name = name;
  truth.effects = {effect};
  return truth;
}

inline TrialOutcome said(int trial, const std::string& verdict, const std::string& family = "",
                         const std::string& named = "") {
  TrialOutcome outcome;
  outcome.trial = trial;
  outcome.said.verdict = verdict;
  outcome.said.family = family;
  outcome.said.named = named;
  if (!named.empty()) outcome.said.candidates = {{named}};
  outcome.speeds = 3;
  outcome.shots = 6;
  for (const ControlName& control : control_names)
    outcome.controls[control.key] = answer_of_set({}, {});
  return outcome;
}

inline TrialCollection trials_of(const std::vector<TrialOutcome>& outcomes,
                                 const std::vector<TrialTruth>& truths) {
  return {.records = records_of(outcomes, truths), .protocols = {}};
}

inline const TrialGate& gate(const std::vector<TrialGate>& gates, const std::string& what) {
  for (const TrialGate& one : gates)
    if (one.what == what) return one;
  throw std::runtime_error("no gate " + what);
}

inline const TrialGate& gate(const TrialScores& scores, const std::string& what) {
  return gate(scores.gates, what);
}

}  // namespace rebound::testing
