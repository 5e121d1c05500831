#pragma once

#include <cmath>

#include "comparisons/models/effects/effect.hpp"

namespace rebound {

/// Is the fault of one shot that of the shot which the chain serves?
///
/// A chain that serves no shot (number 0) has no such fault.
inline bool acts_on(const EffectChoice& fault, const MeasurementChain& chain) {
  return std::lround(fault.parameters.at("shot")) == chain.shot;
}

/// Which of the shots has the fault.
inline EffectParameterCard shot_parameter() {
  return {.name = "shot",
          .sentence = "Its number in the data, from 1.",
          .dimension = dimension::none,
          .range = from_to(1.0, 1e6),
          .default_value = 1.0,
          .kind = ParameterKind::shot};
}

/// Of the number by which a fault scales one shot: a tenth of it is left at least.
inline Range one_shot_range() {
  return from_to(-0.9, 9.0);
}

}  // namespace rebound
