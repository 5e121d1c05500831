#include "comparisons/effects/declarations.hpp"

namespace rebound {

Effect layered_core_effect() {
  return {
      .card = {
          .name = "layered-core",
          .kind = EffectKind::elastic,
          .sentence = "A shell or winding stiffer than the inside, felt while the contact is "
                      "shallow.",
          .equation = "F_e (1 + s exp(-10 x/R))",
          .size_dimension = dimension::none,
          .lowest = -0.9,
          .highest = 50.0,
          .prior_scale = 0.5,
          .signature = "Force rises early and then less steeply: two slopes of F over x; kink "
                       "soon after first touch.",
          .experiment = "Curvature of F(x) at small x, and repeats at other orientations: a "
                        "seam or a winding differs by direction.",
          .source = "Cross 1999 (tennis balls reach half the peak force in the first 0.2 ms)"
      },
      .to_lumped =
          [](const EffectChoice& choice, LumpedProblem& problem) {
            problem.model.mechanisms.elastic.layer = choice.size;
          },
  };
}

}  // namespace rebound
