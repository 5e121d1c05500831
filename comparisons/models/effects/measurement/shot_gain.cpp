#include "comparisons/models/effects/measurement/one_shot.hpp"

namespace rebound {

Effect shot_gain_effect() {
  return {
      .card = {.name = "shot-gain",
               .kind = EffectKind::measurement,
               .family = EffectFamily::measurement,
               .sentence = "One shot was recorded with another gain than the rest.",
               .equation = "reported force = (1 + s) true, in one shot",
               .size_dimension = dimension::none,
               .range = one_shot_range(),
               .prior_scale = 0.05,
               .parameters = {shot_parameter()},
               .signature = "Impulse of one shot against its momentum; all others agree, its "
                            "contact time too.",
               .experiment = "Repeat the shot; look up the range of the amplifier in the protocol.",
               .source = "Momentum balance of one shot"},
      .to_measurement =
          [](const EffectChoice& choice, MeasurementChain& chain) {
            if (acts_on(choice, chain)) chain.force_gain += choice.size;
          },
  };
}

}  // namespace rebound
