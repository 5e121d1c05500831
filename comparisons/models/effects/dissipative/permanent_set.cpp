#include "comparisons/models/effects/dissipative/prony_branch.hpp"
#include "comparisons/models/effects/effect.hpp"

namespace rebound {

Effect permanent_set_effect() {
  return {
      .card = {.name = "permanent-set",
               .kind = EffectKind::dissipative,
               .family = EffectFamily::history,
               .sentence = "A dent that stays: unloading ends before the deflection is back.",
               .equation = "unloading: F_e((x - s x_max)/(1 - s)), nothing below s x_max",
               .size_dimension = dimension::none,
               .range = limit_of<&UnloadingMemory::permanent_set>.range,
               .prior_scale = 0.05,
               .signature = "Force zero at x > 0, early; steeper unloading; e falls equally at all "
                            "speeds; a second hit on the same spot meets a flat.",
               .experiment = "Repeat shots on one spot and the diameter afterwards, hours later: "
                             "relaxation recovers, set stays.",
               .source = "Walton & Braun 1986; foams and cork after repeated impact",
               .moves = ImpactChange{.contact_time = -1, .restitution = -1}},
      .to_lumped =
          [](const EffectChoice& choice, LumpedProblem& problem) {
            problem.model.mechanisms.memory.permanent_set += choice.size;
          },
      .to_fem =
          [](const EffectChoice& choice, FemProblem& problem) {
            // A network beside the material that yields at an elastic strain of
            // 0.03 and 300/s, nearly whatever the rate.
            add_prony_branch(problem.material, {.ratio = choice.size / (1.0 - choice.size),
                                                .relaxation_time = 1e-4,
                                                .relaxes = Relaxes::all,
                                                .rate_exponent = 0.05,
                                                .reference_strain = 0.03});
          },
  };
}

}  // namespace rebound
