#pragma once

#include <string>
#include <vector>

#include "comparisons/evaluation/atlas/atlas.hpp"

namespace rebound {

/// Which error of a cell a map shows.
struct AtlasQuantity {
  std::string name;
  double (*size)(const AtlasCell& cell);  ///< never negative
};

/// Force over time, restitution, contact time, peak force, peak deflection.
const std::vector<AtlasQuantity>& atlas_quantities();

/// The middle and the ninetieth of a hundred of a quantity over materials.
struct AtlasSpread {
  int cells = 0;     ///< that have a number
  int failures = 0;  ///< that have none
  double median = 0.0;
  double ninetieth = 0.0;
};

/// Over all materials, for one law from one speed to another.
AtlasSpread spread_of(const Atlas& atlas, const AtlasQuantity& quantity, std::size_t law,
                      std::size_t from, std::size_t to);

/// The law of least force error at one material, and what to expect of it.
struct AtlasAdvice {
  int law = -1;  ///< index into atlas_laws(); -1: none has a number
  double force_rms = 0.0;
  double restitution = 0.0;
};

/// Best law of a material when calibrated at one speed and used at another.
AtlasAdvice advice_of(const AtlasEntry& entry, std::size_t from, std::size_t to);

}  // namespace rebound
