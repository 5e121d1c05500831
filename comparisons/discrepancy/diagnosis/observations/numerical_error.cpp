#include "comparisons/discrepancy/diagnosis/observations/numerical_error.hpp"

#include <algorithm>
#include <cmath>

namespace rebound {

void add_numerical_error(MeasuredImpact& shot, double error) {
  constexpr std::size_t blocks =
      8;  // of a history: about six in a contact, as many as it has phases
  shot.noise.deviation = std::hypot(shot.noise.deviation, error);
  shot.noise.shared = error;
  shot.noise.shared_by = std::max<std::size_t>(1, shot.trace.force.size() / blocks);
}

}  // namespace rebound
