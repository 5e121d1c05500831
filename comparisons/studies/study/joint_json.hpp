#pragma once

#include <string>
#include <vector>

#include "comparisons/discrepancy/consistency/joint_scalars.hpp"
#include "comparisons/io/results/json.hpp"
#include "comparisons/studies/study/core_study.hpp"

namespace rebound {

/// What all diagnosed cores say together.
Json joint_json(const std::vector<CoreStudy>& cores, const JointScalars& joint);

/// As files call it, e.g. "contact_time".
std::string key_of(ObservedQuantity what);

/// Further numbers of an effect, each with its name.
Json parameters_json(const EffectChoice& effect);

}  // namespace rebound
