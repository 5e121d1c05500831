#include <cmath>

#include "comparisons/models/effects/measurement/one_shot.hpp"

namespace rebound {

Effect odd_shot_effect() {
  return {
      .card = {.name = "odd-shot",
               .kind = EffectKind::measurement,
               .family = EffectFamily::measurement,
               .sentence = "One shot does not belong with the rest: its force and its time are "
                           "scaled, each in its own way.",
               .equation = "reported force = (1 + s) true, its time = (1 + s)^q true, in one shot",
               .size_dimension = dimension::none,
               .range = one_shot_range(),
               .prior_scale = 0.05,
               .parameters = {shot_parameter(),
                              {.name = "time_exponent",
                               .sentence = "q: how its time follows its force; -1 "
                                           "keeps its impulse, as another stiffness does.",
                               .dimension = dimension::none,
                               .range = from_to(-10.0, 10.0),
                               .default_value = -1.0,
                               .fitted = true,
                               .kind = ParameterKind::linear,
                               .tried = {-1.0, 1.0}}},
               .signature = "Peak and contact time of one shot away from the line of all others.",
               .experiment =
                   "Repeat the shot; look up ball, temperature and range in the protocol.",
               .source = "Dimensions: a stiffness of one shot scales its force by k^(2/5) and its "
                         "time by k^(-2/5)"},
      .to_measurement =
          [](const EffectChoice& choice, MeasurementChain& chain) {
            if (!acts_on(choice, chain)) return;
            chain.force_gain += choice.size;
            chain.time_base +=
                std::pow(1.0 + choice.size, choice.parameters.at("time_exponent")) - 1.0;
          },
  };
}

}  // namespace rebound
