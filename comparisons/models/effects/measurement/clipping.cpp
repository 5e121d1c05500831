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
               .tried = {100.0, 178.0, 316.0, 562.0, 1000.0, 1330.0, 1780.0, 2370.0, 3160.0, 4220.0,
                         5620.0, 7500.0, 1.0e4, 1.33e4, 1.78e4, 2.37e4, 3.16e4, 5.62e4, 1e5},
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
