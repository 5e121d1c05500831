#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/discrepancy/trials/trial_answer.hpp"

namespace rebound {

/// What is known of one trial once it has been diagnosed.
struct TrialOutcome {
  int trial = 0;
  TrialAnswer said;  ///< by the diagnosis
  std::string failure;
  double size = 0.0, size_low = 0.0, size_high = 0.0;     ///< of the one effect that is named
  std::optional<double> held_out_before, held_out_after;  ///< reduced whitened χ²
  double held_out_noise = 0.0;                            ///< deviation of it by noise alone
  std::vector<std::string> warnings;
  int speeds = 0;  ///< different ones that the data state
  int shots = 0;
  double seconds = 0.0;                         ///< of the diagnosis, without the controls
  std::map<std::string, TrialAnswer> controls;  ///< by name, on the same data
  std::string protocol;                         ///< digest of what the outcome was made with
};

}  // namespace rebound
