#include <cmath>
#include "comparisons/models/effects/effect.hpp"

namespace rebound {

Effect platen_count_effect() {
  return {
      .card = {.name = "platen-count",
               .kind = EffectKind::measurement,
               .family = EffectFamily::measurement,
               .sentence = "A compression between two platens was read as one contact, or the "
                           "other way round.",
               .equation = "1 or 2 platens, slow compression only",
               .size_dimension = dimension::none,
               .range = from_to(0.0, 2.0),
               .prior_scale = 2.0,
               .signature = "Slow stiffness wrong by 2^1.5 while all dynamic observables stay; "
                            "dynamic over slow stiffness far too large.",
               .experiment = "Compare with the modulus of a block; measure the travel of the "
                             "ball's centre.",
               .source = "Two contacts in series: F = E* (4/3) sqrt(R) (d/2)^1.5"},
      .to_measurement =
          [](const EffectChoice& choice, MeasurementChain& chain) {
            chain.platens = static_cast<int>(std::lround(choice.size));
          },
  };
}

}  // namespace rebound
