#include "comparisons/models/instrument/reported_deflection.hpp"

#include "comparisons/models/instrument/reported_force.hpp"

namespace rebound {

std::vector<double> reported_deflection(const Trace& contact, const MeasurementChain& chain,
                                        std::span<const double> time) {
  // A force channel without filters is what carries any history from a trace to a recorder.
  const Trace carried{.time = contact.time, .force = contact.deflection};
  std::vector<double> deflection = reported_force(
      carried, {.trigger_shift = chain.trigger_shift, .time_base = chain.time_base}, time);
  const std::size_t last = contact.time.size() - 1;
  const auto slope = [&](std::size_t k) {
    return (contact.deflection[k + 1] - contact.deflection[k]) /
           (contact.time[k + 1] - contact.time[k]);
  };
  for (std::size_t i = 0; i < deflection.size(); ++i) {
    const double since = (time[i] - chain.trigger_shift) / (1.0 + chain.time_base);
    if (since < contact.time.front())
      deflection[i] = contact.deflection.front() + slope(0) * (since - contact.time.front());
    if (since > contact.time.back())
      deflection[i] = contact.deflection.back() + slope(last - 1) * (since - contact.time.back());
    deflection[i] = (1.0 + chain.deflection_gain) * deflection[i] + chain.deflection_zero;
  }
  return deflection;
}

}  // namespace rebound
