#include <cmath>
#include <numbers>

#include "comparisons/models/effects/effect.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

namespace {

Plate compliant_plate(const EffectChoice& choice, const Plate& before) {
  if (before.moves())
    throw Error(ExitCode::bad_input,
                "'plate-compliance' needs a plate that stands still before; give the stiffness in "
                "[model.plate] or by the effect");
  Plate plate = before;
  plate.stiffness = 1.0 / choice.size;
  plate.mass = choice.parameters.at("mass");
  plate.damping_ratio = choice.parameters.at("damping_ratio");
  return plate;
}

EffectChoice ringing_plate(double frequency, double strength, double ball_mass) {
  const double omega = 2.0 * std::numbers::pi * frequency, mass = ball_mass / strength;
  return {.name = "plate-compliance",
          .size = 1.0 / (mass * omega * omega),
          .parameters = {{"mass", mass}, {"damping_ratio", 0.02}}};
}

double frequency_of_plate(const EffectChoice& choice) {
  return 0.5 / (std::numbers::pi * std::sqrt(choice.size * choice.parameters.at("mass")));
}

}  // namespace

Effect plate_compliance_effect() {
  return {
      .card = {.name = "plate-compliance",
               .kind = EffectKind::boundary,
               .family = EffectFamily::dynamics,
               .sentence = "The plate gives way: a mass on the spring of its load cell.",
               .equation = "M y'' + c y' + k y = F, s = 1/k; the law sees x - y, the cell reads k "
                           "y + c y'",
               .size_dimension = dimension::length / dimension::force,
               .range = from_to(0.0, 1.0),
               .prior_scale = 2e-08,
               .parameters = {{.name = "mass",
                               .sentence = "Mass of the plate.",
                               .dimension = dimension::mass,
                               .range = limit_of<&Plate::mass>.range,
                               .default_value = 2.0,
                               .fitted = true},
                              {.name = "damping_ratio",
                               .sentence = "Damping ratio of plate and load cell.",
                               .dimension = dimension::none,
                               .range = limit_of<&Plate::damping_ratio>.range,
                               .default_value = 0.02,
                               .fitted = true,
                               .tried = {0.02}}},
               .oscillator = OscillatorCard{ringing_plate, frequency_of_plate, true},
               .signature = "Ringing after contact at a frequency that neither ball nor speed "
                            "changes; impulse of the cell and rebound speed disagree.",
               .experiment = "Strike the bare plate with a hammer; put another mass on it; rebound "
                             "speed from a camera beside the cell.",
               .source = "Maranzano & Hancock 2016 (load cell as a further oscillator)",
               .moves = ImpactChange{}},
      .to_lumped =
          [](const EffectChoice& choice, LumpedProblem& problem) {
            Plate& plate = problem.model.mechanisms.plate;
            plate = compliant_plate(choice, plate);
          },
      .to_fem = [](const EffectChoice& choice,
                   FemProblem& problem) { problem.plate = compliant_plate(choice, problem.plate); },
  };
}

}  // namespace rebound
