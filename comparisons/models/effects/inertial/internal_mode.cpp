#include "comparisons/models/effects/effect.hpp"

namespace rebound {
namespace {

EffectChoice ringing_ball(double frequency, double strength, double /*ball_mass*/) {
  return {.name = "internal-mode",
          .size = strength,
          .parameters = {{"frequency", frequency}, {"damping_ratio", 0.02}}};
}

double frequency_of_mode(const EffectChoice& choice) {
  return choice.parameters.at("frequency");
}

}  // namespace

Effect internal_mode_effect() {
  return {
      .card = {.name = "internal-mode",
               .kind = EffectKind::inertial,
               .family = EffectFamily::dynamics,
               .sentence = "The ball rings: part of its mass moves against the rest.",
               .equation = "s of the mass on a spring at frequency f, ratio zeta; x is the centre "
                           "of mass",
               .size_dimension = dimension::none,
               .range = limit_of<&InternalMode::mass_fraction>.range,
               .prior_scale = 0.1,
               .parameters = {{.name = "frequency",
                               .sentence = "Frequency of the free ball's mode.",
                               .dimension = dimension::frequency,
                               .range = limit_of<&InternalMode::frequency>.range,
                               .default_value = 1200.0,
                               .fitted = true},
                              {.name = "damping_ratio",
                               .sentence = "Damping ratio of the mode.",
                               .dimension = dimension::none,
                               .range = limit_of<&InternalMode::damping_ratio>.range,
                               .default_value = 0.02,
                               .fitted = true,
                               .tried = {0.02},
                               .most_fitted = 0.5}},  // more does not swing: a damper, a memory
               .oscillator = OscillatorCard{ringing_ball, frequency_of_mode},
               .signature = "Ripple of fixed frequency on the force, whatever the speed; energy "
                            "missing from the rebound that is not in the loop.",
               .experiment = "Spectrum of the force against the ball's own modes (tap test); the "
                             "ripple is absent in slow compression.",
               .source = "Lamb 1882 (modes of a sphere); Rayleigh 1906"},
      .to_lumped =
          [](const EffectChoice& choice, LumpedProblem& problem) {
            problem.model.mechanisms.mode = {
                .mass_fraction = choice.size,
                .frequency = choice.parameters.at("frequency"),
                .damping_ratio = choice.parameters.at("damping_ratio")};
          },
  };
}

}  // namespace rebound
