#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/io/results/json.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound {

/// What a diagnosis said of one trial, and nothing of what was hidden in it.
struct TrialOutcome {
  int trial = 0;
  std::string verdict;  ///< as in the results of a diagnosis; "failed" where it ended in an error
  std::string failure;
  std::string family;  ///< empty: none said
  std::vector<std::vector<std::string>> candidates;
  std::string named;  ///< the one effect of verdict "missing"; empty: none, or more than one
  double size = 0.0, size_low = 0.0, size_high = 0.0;
  std::optional<double> held_out_before, held_out_after;  ///< reduced whitened χ²
  double held_out_noise = 0.0;                            ///< deviation of it by noise alone
  std::vector<std::string> warnings;
  double seconds = 0.0;
};

Json to_json(const TrialOutcome& outcome);
/// Errors: Error(corrupt_store) for what is not such a text; `file` is named in it.
TrialOutcome trial_outcome_from(const std::string& text, const std::string& file);

struct TrialRun {
  std::filesystem::path folder;    ///< as the generator wrote it
  std::filesystem::path outcomes;  ///< one file a trial
  std::uint64_t seed = 1;
};

/// Diagnoses every trial that has no outcome yet, several side by side, and returns all outcomes in
/// the order of the trials.
///
/// Errors: Error(bad_input) for a folder without trials; Error(interrupted), with what is complete
/// kept.
std::vector<TrialOutcome> run_trials(const TrialRun& run, const RunControl& control = {});

}  // namespace rebound
