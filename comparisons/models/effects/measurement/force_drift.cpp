#include "comparisons/models/effects/effect.hpp"

namespace rebound {

Effect force_drift_effect() {
  return {
      .card = {.name = "force-drift",
               .kind = EffectKind::measurement,
               .family = EffectFamily::measurement,
               .sentence = "The zero of the force wanders at a constant rate.",
               .equation = "reported force = true + s t, t from first touch",
               .size_dimension = dimension::force / dimension::time,
               .range = from_to(-1e9, 1e9),
               .prior_scale = 1e4,
               .signature = "A slope of the force before and after contact, the same in newtons per"
                            " second at all speeds: more, as a share of the peak, at low speed.",
               .experiment = "Record long before the trigger and long after separation; let the "
                             "amplifier warm up.",
               .source = "Linear trend of the record outside the contact"},
      .to_measurement = [](const EffectChoice& choice,
                           MeasurementChain& chain) { chain.force_drift = choice.size; },
  };
}

}  // namespace rebound
