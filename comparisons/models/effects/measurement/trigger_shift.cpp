#include "comparisons/models/effects/effect.hpp"

namespace rebound {

Effect trigger_shift_effect() {
  return {
      .card = {.name = "trigger-shift",
               .kind = EffectKind::measurement,
               .family = EffectFamily::measurement,
               .sentence = "Time zero is not first touch.",
               .equation = "reported time = true + s",
               .size_dimension = dimension::time,
               .range = from_to(-1.0, 1.0),
               .prior_scale = 20e-6,
               .signature = "The whole record moves; a late start of the integral spoils the "
                            "integrated deflection.",
               .experiment = "Record longer before the trigger; a second channel that sees first "
                             "touch.",
               .source = "Centroid of the force in time"},
      .to_measurement = [](const EffectChoice& choice,
                           MeasurementChain& chain) { chain.trigger_shift = choice.size; },
  };
}

}  // namespace rebound
