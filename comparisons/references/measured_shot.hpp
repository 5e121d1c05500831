#pragma once

#include "comparisons/calibration/reference_shot.hpp"
#include "comparisons/dataset/dataset.hpp"

namespace rebound {

/// A measured trace brought under the shared definitions.
///
///   contact      samples between the first and the last force above the
///                threshold, one sample more at either end, time from zero
///   x(t)         as measured, or ∫(v₀ − (1/m)∫F dt) dt where there is none
///   e            as measured, or ∫F dt/(m v₀) − 1
///
///   threshold    of the instrument, or three standard deviations of its
///                noise, or zero [N]
///
/// Caution: a deflection integrated from the force holds no information of its
///          own; the threshold delays the start, which shifts that deflection
///          by v₀ times the delay.
/// Errors:  Error(bad_input) for a shot without trace, a force that never
///          exceeds the threshold, or a restitution outside (0, 1].
ReferenceShot measured_shot(const Dataset& dataset, const Shot& shot);

}  // namespace rebound
