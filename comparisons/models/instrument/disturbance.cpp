#include "comparisons/models/instrument/disturbance.hpp"

#include <cmath>
#include <numbers>

namespace rebound {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;

double at(const Burst& burst, double since_touch) {
  const double since = since_touch - burst.instant;
  if (since < 0.0) return 0.0;
  return burst.amplitude * std::exp(-since / burst.decay_time) *
         std::sin(turn * burst.frequency * since);
}

}  // namespace

double added_force(const MeasurementChain& chain, double since_touch) {
  double added = chain.force_baseline;
  if (chain.force_drift != 0.0) added += chain.force_drift * since_touch;
  if (chain.hum.amplitude != 0.0)
    added +=
        chain.hum.amplitude * std::sin(turn * chain.hum.frequency * since_touch + chain.hum.phase);
  if (chain.burst.amplitude != 0.0) added += at(chain.burst, since_touch);
  return added;
}

}  // namespace rebound
