#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/discrepancy/trials/trial_outcome.hpp"
#include "comparisons/discrepancy/trials/trial_protocol.hpp"
#include "comparisons/discrepancy/trials/trial_truth.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound {

/// A trial once its truth has been opened.
struct TrialRecord {
  TrialTruth truth;
  TrialOutcome outcome;
};

/// Trials of one folder or many, with what their outcomes were made with.
struct TrialCollection {
  std::vector<TrialRecord> records;
  TrialProtocols protocols;
};

/// Trials as the generator wrote them, and where their outcomes stand.
struct TrialFolder {
  std::filesystem::path data;
  std::filesystem::path outcomes;  ///< folder of their stores
};

struct TrialRun {
  std::vector<TrialFolder> folders;
  std::uint64_t seed = 1;
  std::optional<std::size_t> most{};  ///< diagnoses in this run; the rest stays for the next
  bool ask_fem = false;               ///< for balls in finite elements; it takes seconds a trial
  bool mixed = false;  ///< outcomes of more than one protocol are taken together, and it is said
};

/// How far a run of trials has come.
struct TrialProgress {
  std::size_t with_outcome = 0, trials = 0;

  bool complete() const { return with_outcome == trials; }
};

/// Diagnoses trials that have no outcome yet, several side by side, and keeps each outcome in a
/// store (TrialStore). No truth is opened.
///
/// Progress is that of the trials which this run diagnoses.
/// Errors: Error(bad_input) for a folder without trials, or, before the first diagnosis, where
///         outcomes would be of more than one protocol; Error(corrupt_store) for a store that is
///         damaged or of another version; Error(interrupted), with what is complete kept.
TrialProgress run_trials(const TrialRun& run, const RunControl& control = {});

/// Opens the truths of a complete run.
/// Errors: as read_truths() and records_of(); Error(bad_input) where a trial stands in two folders
///         or an outcome is missing.
TrialCollection open_trials(const TrialRun& run);

/// Outcomes with their truths, trial by trial.
/// Errors: Error(corrupt_store) where trials and truths are not the same.
std::vector<TrialRecord> records_of(const std::vector<TrialOutcome>& outcomes,
                                    const std::vector<TrialTruth>& truths);

}  // namespace rebound
