#include "comparisons/models/effects/effect.hpp"

namespace rebound {

Effect burst_effect() {
  return {
      .card = {.name = "burst",
               .kind = EffectKind::measurement,
               .family = EffectFamily::measurement,
               .sentence = "Something else rings for a while: a door, a cable, a second touch of "
                           "the rig.",
               .equation = "reported force = true + s exp(-(t - t0)/tau) sin(2 pi f (t - t0)) from"
                           " t0 on",
               .size_dimension = dimension::force,
               .range = from_to(-1e6, 1e6),
               .prior_scale = 50.0,
               .parameters = {{.name = "frequency",
                               .sentence = "Of the oscillation.",
                               .dimension = dimension::frequency,
                               .range = from_to(1.0, 1e6),
                               .default_value = 3e3,
                               .fitted = true,
                               .tried = {3.0, 5.0, 8.0, 13.0},
                               .tried_in = TriedIn::per_contact_time},
                              {.name = "decay_time",
                               .sentence = "Time to 1/e of the amplitude.",
                               .dimension = dimension::time,
                               .range = from_to(1e-6, 10.0),
                               .default_value = 0.5e-3,
                               .fitted = true,
                               .tried = {0.3},
                               .tried_in = TriedIn::contact_times},
                              {.name = "instant",
                               .sentence = "When it starts, after first touch.",
                               .dimension = dimension::time,
                               .range = from_to(-1.0, 1.0),
                               .default_value = 0.5e-3,
                               .fitted = true,
                               .kind = ParameterKind::linear,
                               .scale = 50e-6,
                               .tried = {0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.1,
                                         1.2},
                               .tried_in = TriedIn::contact_times}},
               .is_linear = true,
               .signature = "An oscillation that starts at one instant and dies away, of one "
                            "amplitude at all speeds.",
               .experiment = "Repeat the shot; an accelerometer on the frame beside the cell.",
               .source = "Impulse response of a damped oscillator"},
      .to_measurement =
          [](const EffectChoice& choice, MeasurementChain& chain) {
            chain.burst = {.amplitude = choice.size,
                           .frequency = choice.parameters.at("frequency"),
                           .decay_time = choice.parameters.at("decay_time"),
                           .instant = choice.parameters.at("instant")};
          },
  };
}

}  // namespace rebound
