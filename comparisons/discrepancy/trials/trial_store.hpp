#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/discrepancy/trials/trial_outcome.hpp"
#include "comparisons/discrepancy/trials/trial_protocol.hpp"
#include "comparisons/io/result_store/result_store.hpp"

namespace rebound {

/// Outcomes of one folder of trials, in stores of results (comparisons/io/result_store): one file a
/// protocol, trials-DIGEST.sqlite, which holds the protocol as the program of its results.
///
/// Killed at any time, a run of trials finds what it had finished; two may write at a time. May be
/// called from several threads at once.
/// Errors: those of ResultStore, Error(corrupt_store) among them for a store that is no such one.
class TrialStore {
 public:
  /// Opens the stores of `folder` to read them; none need be there.
  explicit TrialStore(std::filesystem::path folder);

  /// The outcome of the trial with this digest, of any protocol that is there.
  std::optional<TrialOutcome> find(const std::string& trial);

  /// From here on outcomes are kept, of this protocol.
  void write(const Json& protocol);
  void keep(const std::string& trial, const TrialOutcome& outcome);

  const TrialProtocols& protocols() const { return protocols_; }  ///< of all its stores
  const std::filesystem::path& folder() const { return folder_; }

 private:
  struct OneProtocol {
    std::string digest;
    ResultStore results;
  };

  std::filesystem::path folder_;
  TrialProtocols protocols_;
  std::mutex guard_;
  std::vector<OneProtocol> stores_;
  std::optional<ResultStore> written_;
};

}  // namespace rebound
