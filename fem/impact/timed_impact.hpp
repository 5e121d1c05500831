#pragma once

#include <chrono>
#include <utility>

#include "fem/interface/fem_result.hpp"
#include "fem/interface/modules.hpp"

namespace rebound::fem {

/// Prepares an impact of one scheme and runs it; the result carries the time of each.
template <class Scheme, class... Arguments>
FemResult timed_impact(const RunControl& control, Arguments&&... arguments) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  Scheme scheme(std::forward<Arguments>(arguments)...);
  const auto ready = Clock::now();
  FemResult result = scheme.run(control);
  result.setup_seconds = std::chrono::duration<double>(ready - start).count();
  result.wall_seconds = std::chrono::duration<double>(Clock::now() - ready).count();
  return result;
}

}  // namespace rebound::fem
