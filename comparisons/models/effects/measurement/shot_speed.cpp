#include "comparisons/models/effects/measurement/one_shot.hpp"

namespace rebound {

Effect shot_speed_effect() {
  return {
      .card = {.name = "shot-speed",
               .kind = EffectKind::measurement,
               .family = EffectFamily::measurement,
               .sentence = "The stated speed of one shot is wrong by a share.",
               .equation = "reported speed = (1 + s) true, in one shot",
               .size_dimension = dimension::none,
               .range = one_shot_range(),
               .prior_scale = 0.05,
               .parameters = {shot_parameter()},
               .signature = "Impulse, peak force and contact time of one shot are those of another "
                            "speed; all others agree.",
               .experiment = "Repeat the shot; read its speed again from the camera.",
               .source = "Momentum balance of one shot"},
      .to_measurement =
          [](const EffectChoice& choice, MeasurementChain& chain) {
            if (acts_on(choice, chain)) chain.speed_error += choice.size;
          },
  };
}

}  // namespace rebound
