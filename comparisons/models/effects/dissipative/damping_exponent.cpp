#include "comparisons/models/effects/effect.hpp"

namespace rebound {

Effect damping_exponent_effect() {
  return {
      .card = {.name = "damping-exponent",
               .kind = EffectKind::dissipative,
               .family = EffectFamily::rate,
               .sentence = "The damping grows with another power of the deflection than the law "
                           "says.",
               .equation = "F_d (x/x_r)^s, x_r = R/10",
               .size_dimension = dimension::none,
               .range = limit_of<&DampingFactors::exponent>.range,
               .prior_scale = 0.2,
               .signature = "Loss moves between onset and peak: width of the F over x loop at "
                            "small against large x; slope of 1 - e over speed.",
               .experiment = "Restitution over a wide range of speeds together with one "
                             "well-sampled loop.",
               .source = "Hanley et al., sliotar core impact, Eq. (3); Kuwabara & Kono 1987 has "
                         "x^0.5, Hunt & Crossley 1975 x^1.5"},
      .to_lumped =
          [](const EffectChoice& choice, LumpedProblem& problem) {
            problem.model.mechanisms.damping.exponent = choice.size;
          },
  };
}

}  // namespace rebound
