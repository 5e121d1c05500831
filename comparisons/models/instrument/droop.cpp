#include "comparisons/models/instrument/droop.hpp"

#include <cmath>

#include "comparisons/models/instrument/sample_step.hpp"

namespace rebound {
namespace {

/// (1 − e^{−x})/x, 1 at x = 0.
double mean_decay(double x) {
  return x == 0.0 ? 1.0 : -std::expm1(-x) / x;
}

}  // namespace

Trace with_droop(const Trace& force, double rate, double last) {
  Trace passed{.time = force.time, .force = force.force, .deflection = {}, .further = {}};
  double y = force.force.front();
  for (std::size_t i = 1; i < force.time.size(); ++i) {
    const double x = rate * (force.time[i] - force.time[i - 1]);
    y = std::exp(-x) * y + (force.force[i] - force.force[i - 1]) * mean_decay(x);
    passed.force[i] = y;
  }
  const double end = force.time.back();
  if (rate == 0.0 || last <= end) return passed;
  // The force drops to zero at once; a sample next to the last keeps the jump.
  const double step = sample_step(force, last - end, most_samples_after);
  constexpr double at_once = 1e-6;
  y -= force.force.back();
  for (double since = at_once * step; since < last - end + step; since += step) {
    passed.time.push_back(end + since);
    passed.force.push_back(y * std::exp(-rate * since));
  }
  return passed;
}

}  // namespace rebound
