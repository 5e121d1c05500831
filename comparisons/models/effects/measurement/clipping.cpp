#include <limits>
#include "comparisons/models/effects/effect.hpp"

namespace rebound {

Effect clipping_effect() {
  return {
      .card = {.name = "clipping",
               .kind = EffectKind::measurement,
               .family = EffectFamily::measurement,
               .sentence = "The amplifier saturates: no reading is above a level.",
               .equation = "reported force = min(true, s)",
               .size_dimension = dimension::force,
               .null = std::numeric_limits<double>::infinity(),
               .range = from_to(1.0, 1e9),
               .prior_scale = 1e4,
               .tried = {0.1, 0.2, 0.4, 0.6, 0.8, 0.9, 0.94, 0.97, 0.985, 1.0},
               .tried_in = TriedIn::largest_readings,
               .signature = "A flat top at one force, at high speed only; impulse short of the "
                            "momentum there.",
               .experiment = "A smaller sensitivity on the same shot; the largest reading over the "
                             "shots against the full scale of the amplifier.",
               .source = "Full scale of amplifier and recorder"},
      .to_measurement = [](const EffectChoice& choice,
                           MeasurementChain& chain) { chain.clipping_level = choice.size; },
  };
}

}  // namespace rebound
