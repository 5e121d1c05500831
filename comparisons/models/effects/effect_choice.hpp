#pragma once

#include <map>
#include <string>
#include <vector>

namespace rebound {

/// An effect as a file names it, or as a diagnosis adds it.
struct EffectChoice {
  std::string name;
  double size = 0.0;                         ///< SI, by the card
  std::map<std::string, double> parameters;  ///< those left out take the card's default
  std::vector<double> size_of_balls{};  ///< in place of `size` where balls differ; empty: alike

  friend bool operator==(const EffectChoice&, const EffectChoice&) = default;
};

}  // namespace rebound
