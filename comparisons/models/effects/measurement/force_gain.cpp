#include "comparisons/models/effects/effect.hpp"

namespace rebound {

Effect force_gain_effect() {
  return {
      .card = {.name = "force-gain",
               .kind = EffectKind::measurement,
               .family = EffectFamily::measurement,
               .sentence = "The load cell reads a constant factor too much or too little.",
               .equation = "reported force = (1 + s) true",
               .size_dimension = dimension::none,
               .range = from_to(-0.9, 9.0),
               .prior_scale = 0.03,
               .signature = "Impulse of the force against m v0 (1 + e); contact time untouched. "
                            "Not separable from a mass error.",
               .experiment = "Calibrate the cell with a weight; rebound speed from a camera.",
               .source = "Momentum balance"},
      .to_measurement = [](const EffectChoice& choice,
                           MeasurementChain& chain) { chain.force_gain += choice.size; },
  };
}

}  // namespace rebound
