#include "comparisons/models/effects/effect.hpp"

namespace rebound {

Effect time_base_effect() {
  return {
      .card = {.name = "time-base",
               .kind = EffectKind::measurement,
               .family = EffectFamily::measurement,
               .sentence = "The recorder's clock runs fast by a constant share.",
               .equation = "reported time = (1 + s) true, both from first touch",
               .size_dimension = dimension::none,
               .range = from_to(-0.9, 9.0),
               .prior_scale = 0.02,
               .signature = "Contact time and impulse wrong by one share at all speeds. Not "
                            "separable from a force gain while the stiffness is fitted: both scale "
                            "the impulse alone.",
               .experiment = "Record a reference oscillator; contact time by another recorder.",
               .source = "Momentum balance: a force over a stretched time has the impulse of a "
                         "larger one"},
      .to_measurement = [](const EffectChoice& choice,
                           MeasurementChain& chain) { chain.time_base = choice.size; },
  };
}

}  // namespace rebound
