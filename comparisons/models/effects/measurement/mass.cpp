#include "comparisons/models/effects/effect.hpp"

namespace rebound {

Effect mass_effect() {
  return {
      .card = {.name = "mass",
               .kind = EffectKind::measurement,
               .family = EffectFamily::measurement,
               .sentence = "The mass is not what is stated.",
               .equation = "reported mass = (1 + s) true",
               .size_dimension = dimension::none,
               .range = from_to(-0.9, 9.0),
               .prior_scale = 0.005,
               .signature = "Impulse of the force against m v0 (1 + e). Not separable from a force "
                            "gain.",
               .experiment = "Weigh the ball again, at the humidity of the shots.",
               .source = "Momentum balance"},
      .to_measurement = [](const EffectChoice& choice,
                           MeasurementChain& chain) { chain.mass_error = choice.size; },
  };
}

}  // namespace rebound
