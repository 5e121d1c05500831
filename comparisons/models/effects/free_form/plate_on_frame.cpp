#include <cmath>
#include <numbers>

#include "comparisons/models/effects/boundary/plate_on_load_cell.hpp"

namespace rebound {
namespace {

EffectParameterCard frame_ratio(const std::string& name, const std::string& sentence) {
  return {.name = name,
          .sentence = sentence,
          .dimension = dimension::none,
          .range = from_to(1e-3, 1e3),
          .default_value = 1.0,
          .fitted = true};
}

std::vector<EffectParameterCard> parameters() {
  std::vector<EffectParameterCard> all =
      plate_parameters("Damping ratio of the load cell, and of the frame.");
  all.push_back(
      frame_ratio("frame_stiffness_ratio", "Stiffness of the frame over that of the load cell."));
  all.push_back(frame_ratio("frame_mass_ratio", "Mass of the frame over that of the plate."));
  return all;
}

/// Of a = k/M, b = k/M_f and g = k_f/M_f, a + b + g is the sum of both squared frequencies and a g
/// their product: a is free between them, and the rest follows.
EffectChoice ringing_frame(double slow, double fast, double share, double strength,
                           double ball_mass) {
  const double lower = std::pow(2.0 * std::numbers::pi * slow, 2);
  const double upper = std::pow(2.0 * std::numbers::pi * fast, 2);
  const double a = std::pow(lower, 1.0 - share) * std::pow(upper, share);
  const double g = lower * upper / a, b = lower + upper - a - g;
  const double mass = ball_mass / strength;
  return {.name = "plate-on-frame",
          .size = 1.0 / (mass * a),
          .parameters = {{"mass", mass},
                         {"damping_ratio", 0.02},
                         {"frame_stiffness_ratio", g / b},
                         {"frame_mass_ratio", a / b}}};
}

Plate plate_on_frame(const EffectChoice& choice, const Plate& before) {
  Plate plate = plate_on_load_cell(choice, before);
  plate.frame = {.stiffness = plate.stiffness * choice.parameters.at("frame_stiffness_ratio"),
                 .mass = plate.mass * choice.parameters.at("frame_mass_ratio"),
                 .damping_ratio = plate.damping_ratio};
  return plate;
}

}  // namespace

Effect plate_on_frame_effect() {
  return {
      .card = {.name = "plate-on-frame",
               .kind = EffectKind::boundary,
               .family = EffectFamily::dynamics,
               .sentence = "The plate gives way, and so does what its load cell stands on: the "
                           "dynamics family with two masses.",
               .equation = "M y'' = F - C, M_f z'' = C - k_f z - c_f z', C = k (y - z) + c (y' - "
                           "z'), s = 1/k; the law sees x - y, the cell reads C",
               .size_dimension = dimension::length / dimension::force,
               .range = from_to(0.0, 1.0),
               .prior_scale = 2e-08,
               .parameters = parameters(),
               .oscillator_pair = OscillatorPairCard{ringing_frame},
               .signature = "Ringing after contact at two frequencies that neither ball nor speed "
                            "changes.",
               .experiment = "Strike the bare plate and the bare frame with a hammer.",
               .source = "two degrees of freedom in series, e.g. Meirovitch 2001",
               .is_free_form = true,
               .free_form_of = "plate-compliance",
               .contains = "plate-compliance"},
      .to_lumped = [](const EffectChoice& choice, LumpedProblem& problem) {
        Plate& plate = problem.model.mechanisms.plate;
        if (choice.size > 0.0) plate = plate_on_frame(choice, plate);
      }};
}

}  // namespace rebound
