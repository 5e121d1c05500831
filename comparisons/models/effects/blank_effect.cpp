#include "comparisons/models/effects/effect.hpp"
#include "lumped/problem/error.hpp"

// To add an effect: bash comparisons/setup/new effect NAME
/// An effect to copy, with a form in both tiers. It compiles, and it is in no list.
namespace rebound {

Effect blank_effect() {
  return {
      .card = {.name = "blank",
               .kind = EffectKind::elastic,
               .family = EffectFamily::elastic,
               .sentence = "The ball is stiffer than it was taken for, by this share.",
               .equation = "stiffness (1 + s)",
               .size_dimension = dimension::none,
               .range = from_to(-0.9, 9.0),
               .prior_scale = 0.2,
               .signature = "Where does it show: force, time, restitution, over the speed?",
               .experiment = "What would tell it from its rivals?",
               .source = "none: an effect to copy",
               .moves = ImpactChange{.peak_force = 1, .contact_time = -1}},
      // A form that a tier has not is left out. Neither is called at the null size.
      .to_lumped =
          [](const EffectChoice& choice, LumpedProblem& problem) {
            LumpedModel& model = problem.model;
            if (!model.parameters.contains("stiffness"))
              throw Error(ExitCode::bad_input, "'blank' needs a law with a stiffness");
            model.parameters["stiffness"] *= 1.0 + choice.size;
            for (ParametersAtSpeed& at : model.at_speed)
              if (at.parameters.contains("stiffness"))
                at.parameters["stiffness"] *= 1.0 + choice.size;
          },
      .to_fem = [](const EffectChoice& choice,
                   FemProblem& problem) { problem.material.youngs_modulus *= 1.0 + choice.size; },
  };
}

}  // namespace rebound
