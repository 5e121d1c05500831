#include "comparisons/models/effects/effect.hpp"

namespace rebound {

Effect speed_calibration_effect() {
  return {
      .card = {.name = "speed-calibration",
               .kind = EffectKind::measurement,
               .family = EffectFamily::measurement,
               .sentence = "The approach speed is read a constant factor wrong.",
               .equation = "reported speed = (1 + s) true",
               .size_dimension = dimension::none,
               .range = from_to(-0.9, 9.0),
               .prior_scale = 0.02,
               .signature = "Impulse and peak force too low or high for the stated speed, at all "
                            "speeds alike; contact time hardly.",
               .experiment = "A second speed measurement: light gate beside camera, or a drop from "
                             "a known height.",
               .source = "Momentum balance"},
      .to_measurement = [](const EffectChoice& choice,
                           MeasurementChain& chain) { chain.speed_error += choice.size; },
  };
}

}  // namespace rebound
