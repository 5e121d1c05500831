#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rebound {

/// One effect hidden in a trial.
struct TrialEffect {
  std::string family;         ///< as the diagnosis names families, or "out_of_family"
  std::string form;           ///< the generator's own name
  std::string registry_name;  ///< the nearest effect of this project's list
  bool in_registry = false;   ///< of the very form of the list
  std::optional<double> registry_size;
};

struct TrialTruth {
  std::string set;         ///< of the generator: "calibration", "scoring"
  std::uint64_t seed = 0;  ///< that it was drawn from
  int trial = 0;
  std::vector<TrialEffect> effects;  ///< empty: a null
  double visible_chi_square = 0.0;
  /// Largest cosine between what shows of the truth and of any form of another family, and of
  /// another name; absent where the generator did not say.
  std::optional<double> nearest_family, nearest_name;
  std::string noise_colour, noise_stated;
  /// What a ball in finite elements is made of; empty: a ball that obeys a law of a point.
  std::string ball;
  /// Tier of the believed model: "lumped", or "fem" of a ball in finite elements alone.
  std::string believed = "lumped";
  double noise_share = 0.0;  ///< one deviation over the smallest peak force of the believed model
};

/// Reads the truths of a folder.
/// Errors: Error(corrupt_store) where the bytes of a truth are not those that were sealed, or no
/// seal stands for it.
std::vector<TrialTruth> read_truths(const std::filesystem::path& folder);

}  // namespace rebound
