#include "comparisons/models/effects/effect.hpp"

namespace rebound {

Effect quantisation_effect() {
  return {
      .card = {.name = "quantisation",
               .kind = EffectKind::measurement,
               .family = EffectFamily::measurement,
               .sentence = "The recorder knows few levels: every reading is rounded to the next.",
               .equation = "reported force = s round(true/s), noise included",
               .size_dimension = dimension::force,
               .range = limit_of<&MeasurementChain::rounding_step>.range,
               .prior_scale = 10.0,
               .told_by_readings = true,
               .signature = "Readings repeat a few values, whole steps apart; none between them.",
               .experiment = "A smaller range of the recorder on the same shot.",
               .source = "Resolution of the recorder; Widrow, Kollar & Liu 1996"},
      .to_measurement = [](const EffectChoice& choice,
                           MeasurementChain& chain) { chain.rounding_step = choice.size; },
  };
}

}  // namespace rebound
