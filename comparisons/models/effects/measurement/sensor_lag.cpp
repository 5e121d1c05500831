#include "comparisons/models/effects/effect.hpp"

namespace rebound {

Effect sensor_lag_effect() {
  return {
      .card = {.name = "sensor-lag",
               .kind = EffectKind::measurement,
               .family = EffectFamily::measurement,
               .sentence = "The sensor follows the force late, by one pole or two.",
               .equation = "s y' = F - y, then r s z' = y - z with r the second share",
               .size_dimension = dimension::time,
               .range = from_to(0.0, 1.0),
               .prior_scale = 2e-5,
               .parameters = {{.name = "second_share",
                               .sentence = "Time constant of the second pole over the first.",
                               .dimension = dimension::none,
                               .range = from_to(0.0, 1.0),
                               .default_value = 0.5,
                               .fitted = true,
                               .kind = ParameterKind::linear,
                               .scale = 0.3}},
               .signature =
                   "Peak lower and late, the tail longer than the rise; the impulse stays.",
               .experiment = "The step response of the chain: a weight taken off the cell at once.",
               .source =
                   "first- and second-order instruments, Doebelin, Measurement Systems, 2003"},
      .to_measurement =
          [](const EffectChoice& choice, MeasurementChain& chain) {
            chain.lag = choice.size;
            chain.second_lag = choice.size * choice.parameters.at("second_share");
          },
  };
}

}  // namespace rebound
