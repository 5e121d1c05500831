#include "comparisons/models/effects/effect.hpp"

namespace rebound {

Effect contact_time_threshold_effect() {
  return {
      .card = {.name = "contact-time-threshold",
               .kind = EffectKind::measurement,
               .family = EffectFamily::measurement,
               .sentence = "Contact time was read where the force passes a threshold.",
               .equation = "contact time between crossings of s",
               .size_dimension = dimension::force,
               .range = from_to(0.0, 1000000.0),
               .prior_scale = 10.0,
               .signature = "Contact times short by what the pulse spends below the threshold: "
                            "more at low speed, in proportion to the long tail.",
               .experiment = "Report it at two thresholds from the same record.",
               .source = "Thresholded width of the pulse"},
      .to_measurement = [](const EffectChoice& choice,
                           MeasurementChain& chain) { chain.contact_threshold = choice.size; },
  };
}

}  // namespace rebound
