#pragma once

#include <algorithm>

#include "lumped/problem/trace.hpp"

namespace rebound {

/// Mean distance of a trace's samples, by which a filter goes on over `reach` [s]; but no more than
/// `most` steps, however short the contact was.
/// Limit:   a contact that ends as it begins -> test LagTest.AShortContactMakesNoEndlessRecord.
inline double sample_step(const Trace& trace, double reach, double most) {
  const double duration = trace.time.back() - trace.time.front();
  return std::max(duration / static_cast<double>(trace.time.size() - 1), reach / most);
}

/// Steps of what follows a contact behind a filter.
inline constexpr double most_samples_after = 1e4;

}  // namespace rebound
