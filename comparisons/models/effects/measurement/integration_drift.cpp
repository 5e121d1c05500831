#include "comparisons/models/effects/effect.hpp"

namespace rebound {

Effect integration_drift_effect() {
  return {
      .card = {.name = "integration-drift",
               .kind = EffectKind::measurement,
               .family = EffectFamily::measurement,
               .sentence = "The integrated deflection runs away with time squared.",
               .equation = "x + s t^2/2, integrated deflections only",
               .size_dimension = dimension::acceleration,
               .range = from_to(-1000000.0, 1000000.0),
               .prior_scale = 50.0,
               .signature = "Deflection at separation grows with the square of contact time; the "
                            "force is untouched.",
               .experiment = "An independent deflection: camera or laser.",
               .source = "Double integration of an offset"},
      .to_measurement = [](const EffectChoice& choice,
                           MeasurementChain& chain) { chain.integration_drift = choice.size; },
  };
}

}  // namespace rebound
