#include <limits>
#include "comparisons/models/effects/effect.hpp"

namespace rebound {

Effect bandwidth_effect() {
  return {
      .card = {.name = "bandwidth",
               .kind = EffectKind::measurement,
               .family = EffectFamily::measurement,
               .sentence = "The chain is slow: fast parts of the force are smoothed and late.",
               .equation = "causal 4-pole Butterworth, -3 dB at s",
               .size_dimension = dimension::frequency,
               .null = std::numeric_limits<double>::infinity(),
               .range = from_to(1.0, 1000000000.0),
               .prior_scale = 10000.0,
               .signature = "Peak lower, later and wider, contact longer by a constant time at all "
                            "speeds; the impulse stays.",
               .experiment = "Two cut-offs on the same shot; cut-off above five to ten over the "
                             "contact time.",
               .source = "Gaberson; step response of the filter"},
      .to_measurement = [](const EffectChoice& choice,
                           MeasurementChain& chain) { chain.bandwidth = choice.size; },
  };
}

}  // namespace rebound
