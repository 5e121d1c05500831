#pragma once

#include "comparisons/accuracy/verification/verification_part.hpp"
#include "fem/interface/modules.hpp"

namespace rebound {

/// What this process has grown by at most since it was made: peak resident
/// memory less what was resident then, free memory handed back before.
///
/// Caution: of the whole process; nothing else may run meanwhile. Works where
///          /proc/self/clear_refs can be written (Linux); elsewhere `known()` is false.
class MemoryGrowth {
 public:
  MemoryGrowth();
  bool known() const { return before_ > 0.0; }
  double bytes() const;

 private:
  double before_ = 0.0;
};

/// Memory of one impact over its cells: mesh, body, set-up and the first steps
/// (a trace does not grow with the cells). Rows: the power of the cells that it
/// grows with, and measured over estimated (memory_of_impact), at most one.
/// Both schemes; explicit also with three branches and Mullins softening.
/// Without its rows, and so a failure of the suite, where the system does not tell. Some seconds.
VerificationPart verify_memory(const FemTier& tier, const RunControl& control);

}  // namespace rebound
