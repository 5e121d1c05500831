#include <algorithm>

#include "comparisons/models/effects/effect.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

Effect velocity_exponent_effect() {
  return {
      .card = {.name = "velocity-exponent",
               .kind = EffectKind::dissipative,
               .family = EffectFamily::rate,
               .sentence = "Damping that is not in proportion to the rate.",
               .equation = "F_d |x'/v_r|^s, v_r = 10 m/s",
               .size_dimension = dimension::none,
               .range = limit_of<&DampingFactors::velocity_exponent>.range,
               .prior_scale = 0.2,
               .signature = "Slope of 1 - e over speed at fixed loop shape; towards s = -1 the "
                            "loss is of friction type and e constant.",
               .experiment = "Restitution at speeds a decade apart; the loop of a slow cyclic "
                             "compression.",
               .source = "Slopes of 1 - e over speed: 0 structural, 0.2 viscoelastic sphere, 1 "
                         "Hunt-Crossley with constant damping",
               .moves = ImpactChange{}},
      .to_lumped =
          [](const EffectChoice& choice, LumpedProblem& problem) {
            problem.model.mechanisms.damping.velocity_exponent = choice.size;
          },
      .to_fem =
          [](const EffectChoice& choice, FemProblem& problem) {
            if (problem.material.branches.empty())
              throw Error(ExitCode::bad_input,
                          "the material has no branch whose damping could depend on the rate");
            constexpr double reference_speed = 10.0;
            const double rate = reference_speed / problem.sphere.diameter;
            for (PronyBranch& branch : problem.material.branches) {
              branch.rate_exponent = 1.0 + choice.size;
              branch.reference_strain = std::min(0.2, rate * branch.relaxation_time);
            }
          },
  };
}

}  // namespace rebound
