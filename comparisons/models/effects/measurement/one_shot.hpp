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

}  // namespace rebound
