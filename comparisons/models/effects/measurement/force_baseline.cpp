#include "comparisons/models/effects/effect.hpp"

namespace rebound {

Effect force_baseline_effect() {
  return {
      .card = {.name = "force-baseline",
               .kind = EffectKind::measurement,
               .family = EffectFamily::measurement,
               .sentence = "The force is offset.",
               .equation = "reported force = true + s",
               .size_dimension = dimension::force,
               .range = from_to(-100000.0, 100000.0),
               .prior_scale = 10.0,
               .signature = "Mean of the force before contact; integrated deflection does not come "
                            "back.",
               .experiment = "Record longer before the trigger.",
               .source = "Mean of the record before first touch"},
      .to_measurement = [](const EffectChoice& choice,
                           MeasurementChain& chain) { chain.force_baseline = choice.size; },
  };
}

}  // namespace rebound
