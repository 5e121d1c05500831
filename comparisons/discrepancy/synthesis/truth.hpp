#pragma once

#include <string>

#include "comparisons/discrepancy/synthesis/synthesize.hpp"
#include "comparisons/io/results/json.hpp"

namespace rebound {

/// What is hidden in a synthetic experiment: the file that made it, effects
/// with their sizes, seed, and what was drawn.
Json truth_json(const SynthesisFile& file, const std::string& file_text, const Synthesis& made);

/// A truth under seal: its bytes can be shown later to be the ones that the
/// seal was made of, and cannot be guessed from it.
struct SealedTruth {
  std::string truth;  ///< JSON text with a 256-bit nonce inside
  std::string seal;   ///< JSON text: SHA-256 of those bytes
};

/// The nonce comes from the system's own source of randomness, not from the
/// seed: a seed could be tried out.
SealedTruth seal(Json truth);

}  // namespace rebound
