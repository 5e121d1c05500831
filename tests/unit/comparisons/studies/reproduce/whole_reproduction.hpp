#pragma once

#include "comparisons/models/installation.hpp"
#include "comparisons/studies/reproduce/reproduction.hpp"

namespace rebound::testing {

/// The paper's numbers, computed once a program.
inline const Reproduction& whole_reproduction() {
  static const Reproduction made = reproduce(data_folder());
  return made;
}

}  // namespace rebound::testing
