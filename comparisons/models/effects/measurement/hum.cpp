#include <numbers>
#include "comparisons/models/effects/effect.hpp"

namespace rebound {

using std::numbers::pi;

Effect hum_effect() {
  return {
      .card = {.name = "hum",
               .kind = EffectKind::measurement,
               .family = EffectFamily::measurement,
               .sentence = "A sinusoid lies on the force, locked to the trigger.",
               .equation = "reported force = true + s sin(2 pi f t + phase), t from first touch",
               .size_dimension = dimension::force,
               .range = from_to(-1e6, 1e6),
               .prior_scale = 20.0,
               .parameters = {{.name = "frequency",
                               .sentence = "Of the sinusoid.",
                               .dimension = dimension::frequency,
                               .range = from_to(1.0, 1e6),
                               .default_value = 1e3,
                               .fitted = true,
                               .tried = {0.15, 0.25, 0.4, 0.55, 0.75, 1.0, 1.5, 2.0, 2.6, 3.3, 4.1,
                                         5.0, 6.0},
                               .tried_in = TriedIn::per_contact_time},
                              {.name = "phase",
                               .sentence = "At first touch, in radians.",
                               .dimension = dimension::none,
                               .range = from_to(-4.0 * pi, 4.0 * pi),
                               .default_value = 0.0,
                               .fitted = true,
                               .kind = ParameterKind::linear,
                               .tried = {0.0, 0.5 * pi}}},
               .is_linear = true,
               .signature = "An oscillation before, during and after contact, of one amplitude and "
                            "frequency at all speeds.",
               .experiment =
                   "Record without an impact; move the cables; the spectrum of the record "
                   "before contact.",
               .source = "Spectrum of the record before first touch"},
      .to_measurement =
          [](const EffectChoice& choice, MeasurementChain& chain) {
            chain.hum = {.amplitude = choice.size,
                         .frequency = choice.parameters.at("frequency"),
                         .phase = choice.parameters.at("phase")};
          },
  };
}

}  // namespace rebound
