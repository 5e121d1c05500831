#include "comparisons/models/effects/effect.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

Effect low_loss_damping_formula_effect() {
  return {
      .card = {.name = "low-loss-damping-formula",
               .kind = EffectKind::damping_formula,
               .family = EffectFamily::rate,
               .sentence = "The damping was computed from the restitution by a formula that holds "
                           "for low loss only.",
               .equation = "damping = (1 - s) formula + s exact",
               .size_dimension = dimension::none,
               .range = limit_of<&LumpedModel::exact_damping_share>.range,
               .prior_scale = 1.0,
               .is_switch = true,
               .signature = "The integrated model returns 0.1 to 0.2 more restitution than it was "
                            "given; peak of the force too low and late, tail too short.",
               .experiment = "No experiment: integrate the model and compare the restitution that "
                             "goes in with the one that comes out.",
               .source = "p (1 + e) = ln[(1 + p)/(1 - p e)], p = damping times speed over "
                         "stiffness; Hanley et al. use Eq. (8)"},
      .to_lumped =
          [](const EffectChoice& choice, LumpedProblem& problem) {
            LumpedModel& model = problem.model;
            if (!model.restitution || model.damping_formula.empty())
              throw Error(ExitCode::bad_input,
                          "'low-loss-damping-formula' needs a model given by a restitution and a "
                          "damping formula");
            if (choice.size == 1.0)
              model.damping_formula = "exact";
            else
              model.exact_damping_share = choice.size;
          },
  };
}

}  // namespace rebound
