#include "comparisons/models/effects/dissipative/prony_branch.hpp"
#include "comparisons/models/effects/effect.hpp"

namespace rebound {

Effect relaxation_effect() {
  return {
      .card = {.name = "relaxation",
               .kind = EffectKind::dissipative,
               .family = EffectFamily::memory,
               .sentence = "One relaxation time more: part of the stiffness fades during the "
                           "contact.",
               .equation = "F + q, q' = s F_e' - q/tau",
               .size_dimension = dimension::none,
               .range = limit_of<&RelaxationBranch::ratio>.range,
               .prior_scale = 0.3,
               .parameters = {{.name = "relaxation_time",
                               .sentence = "Time in which the branch fades.",
                               .dimension = dimension::time,
                               .range = limit_of<&RelaxationBranch::relaxation_time>.range,
                               .default_value = 1e-3,
                               .fitted = true,
                               .tried = {0.1, 0.3, 1.0, 3.0, 10.0},
                               .tried_in = TriedIn::contact_times}},
               .fades_in = "relaxation_time",
               .signature = "Force ends at x > 0 and its centroid comes early; a dent that "
                            "recovers after the ball has left; stiffness grows with rate.",
               .experiment = "Hold and relax, or an independent deflection at separation; two "
                             "speeds at least, for one hit cannot tell it from permanent set.",
               .source = "Schwager & Poeschel 2008 (delayed recovery); Cross 1999; standard linear "
                         "solid",
               .moves = ImpactChange{.peak_force = 1, .contact_time = -1, .restitution = -1}},
      .to_lumped =
          [](const EffectChoice& choice, LumpedProblem& problem) {
            problem.model.mechanisms.relaxation = {
                .ratio = choice.size, .relaxation_time = choice.parameters.at("relaxation_time")};
          },
      .to_fem =
          [](const EffectChoice& choice, FemProblem& problem) {
            add_prony_branch(problem.material,
                             {.ratio = choice.size,
                              .relaxation_time = choice.parameters.at("relaxation_time"),
                              .relaxes = Relaxes::all});
          },
  };
}

}  // namespace rebound
