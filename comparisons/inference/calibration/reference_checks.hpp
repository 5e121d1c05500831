#pragma once

#include <vector>

#include "comparisons/inference/calibration/law_calibration.hpp"

namespace rebound {

/// What any reference must have before something is fitted to it.
/// Errors: Error(bad_input) for fewer than five samples, columns of unequal
///         length, numbers that are none, time that does not go forward, and a
///         force or deflection that is flat or never positive.
void check_reference(const MeasuredImpact& shot);

/// known when there are shots and every one states its force uncertainty.
/// Errors: Error(bad_input) for no shots.
NoiseKnowledge noise_of(const std::vector<MeasuredImpact>& shots);

/// σ of a force sample: the stated one, or the weight that stands for it [N].
double weight_of(const MeasuredImpact& shot, NoiseKnowledge noise, Weighting weighting);

}  // namespace rebound
