#include <cmath>

#include "comparisons/models/effects/effect.hpp"

namespace rebound {

Effect ageing_effect() {
  return {
      .card = {.name = "ageing",
               .kind = EffectKind::measurement,
               .family = EffectFamily::measurement,
               .sentence = "The ball changes from shot to shot: it warms up, wears or sets. The "
                           "shots are not of one ball, and no family of effects says so.",
               .equation = "stiffness and damping times e^(s (i - 1)) in shot i of the data",
               .size_dimension = dimension::none,
               .range = from_to(-0.5, 0.5),
               .prior_scale = 0.01,
               .follows_shot_order = true,
               .signature = "Peaks that rise, and contact times that fall, with the number of the "
                            "shot at one and the same speed.",
               .experiment = "The same speeds in another order; the first shot once more at the "
                             "end.",
               .source = "Dimensions: a stiffness of Hertz's law, and damping with it, scale the "
                         "force by k^(2/5) and its time by k^(-2/5)"},
      .to_measurement =
          [](const EffectChoice& choice, MeasurementChain& chain) {
            if (chain.shot == 0) return;  // of no collection
            constexpr double share_of_force = 0.4;
            const double factor = std::exp(share_of_force * choice.size * (chain.shot - 1));
            chain.force_gain += factor - 1.0;
            chain.time_base += 1.0 / factor - 1.0;
          },
  };
}

}  // namespace rebound
