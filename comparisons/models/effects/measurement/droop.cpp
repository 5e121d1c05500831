#include "comparisons/models/effects/effect.hpp"

namespace rebound {

Effect droop_effect() {
  return {
      .card = {.name = "droop",
               .kind = EffectKind::measurement,
               .family = EffectFamily::measurement,
               .sentence = "The charge amplifier leaks: what is constant decays.",
               .equation = "y' = F' - s y, s = 1/time constant",
               .size_dimension = dimension::frequency,
               .range = from_to(0.0, 1e5),
               .prior_scale = 10.0,
               .signature = "Undershoot after separation that decays with the time constant, in "
                            "proportion to the impulse: the record ends below zero.",
               .experiment = "A longer time constant on the same shot; a weight taken off the cell "
                             "at once.",
               .source = "Serridge & Licht 1987, lower limiting frequency of charge amplifiers"},
      .to_measurement = [](const EffectChoice& choice,
                           MeasurementChain& chain) { chain.droop = choice.size; },
  };
}

}  // namespace rebound
