#include <cmath>
#include <numbers>

#include "comparisons/models/effects/boundary/plate_on_load_cell.hpp"

namespace rebound {
namespace {

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
               .parameters = plate_parameters("Damping ratio of plate and load cell."),
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
            plate = plate_on_load_cell(choice, plate);
          },
      .to_fem =
          [](const EffectChoice& choice, FemProblem& problem) {
            problem.plate = plate_on_load_cell(choice, problem.plate);
          },
  };
}

}  // namespace rebound
