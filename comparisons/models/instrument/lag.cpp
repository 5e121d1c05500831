#include "comparisons/models/instrument/lag.hpp"

#include <cmath>

#include "comparisons/models/instrument/sample_step.hpp"

namespace rebound {

Trace with_lag(const Trace& force, double time_constant, double last) {
  Trace passed{.time = force.time, .force = force.force, .deflection = {}, .further = {}};
  if (time_constant == 0.0) return passed;
  double y = force.force.front();
  for (std::size_t i = 1; i < force.time.size(); ++i) {
    const double x = (force.time[i] - force.time[i - 1]) / time_constant;
    const double kept = std::exp(-x), mean = -std::expm1(-x) / x;
    y = kept * y + force.force[i - 1] * (mean - kept) + force.force[i] * (1.0 - mean);
    passed.force[i] = y;
  }
  const double end = force.time.back();
  const double step = sample_step(force, last - end, most_samples_after);
  for (double since = step; since < last - end + step; since += step) {
    passed.time.push_back(end + since);
    passed.force.push_back(y * std::exp(-since / time_constant));
  }
  return passed;
}

}  // namespace rebound
