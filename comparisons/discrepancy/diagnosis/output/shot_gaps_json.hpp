#pragma once

#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"
#include "comparisons/io/results/json.hpp"

/// What is left over shot by shot, for `to_json`.
namespace rebound {

/// Of the believed model: the shots that the fit saw, and those that it did not.
Json gap_of_shots(const Diagnosis& diagnosis);

/// Of FE, before and after the effect that it was given: the shots that it looks at, where a
/// verdict rests on it; else null.
Json gap_of_shots_in_fem(const Diagnosis& diagnosis);

}  // namespace rebound
