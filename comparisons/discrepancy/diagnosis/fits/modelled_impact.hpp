#pragma once

#include "lumped/problem/plate.hpp"
#include "lumped/problem/result.hpp"

namespace rebound {

/// What a diagnosis reads of an impact that a believed model was run for, whatever the tier.
struct ModelledImpact {
  Trace trace;
  ImpactScalars scalars;
  Plate plate;  ///< it was run on
};

}  // namespace rebound
