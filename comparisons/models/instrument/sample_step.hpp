#pragma once

#include <algorithm>
#include <vector>

#include "lumped/problem/trace.hpp"

namespace rebound {

/// Mean distance of two instants and more [s].
inline double mean_sample_step(const std::vector<double>& time) {
  return (time.back() - time.front()) / static_cast<double>(time.size() - 1);
}

/// Mean distance of a trace's samples, by which a filter goes on over `reach` [s]; but no more than
/// `most` steps, however short the contact was.
/// Limit:   a contact that ends as it begins -> test LagTest.AShortContactMakesNoEndlessRecord.
inline double sample_step(const Trace& trace, double reach, double most) {
  return std::max(mean_sample_step(trace.time), reach / most);
}

/// Steps of what follows a contact behind a filter.
inline constexpr double most_samples_after = 1e4;

}  // namespace rebound
