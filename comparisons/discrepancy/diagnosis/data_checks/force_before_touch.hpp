#pragma once

#include <optional>

#include "comparisons/discrepancy/diagnosis/data_checks/data_checks.hpp"
#include "comparisons/io/dataset/dataset.hpp"

namespace rebound {

constexpr const char* before_touch = "before-touch";

/// Does the force change before the ball touches the plate? Of each record what precedes the
/// contact is parted into blocks of a tenth of it, a seventh of it before the touch left out:
///
///   d = F_n − mean of the first two thirds,   t = Σ d/(s √Σ(1 + 1/h)),   s² of the first h blocks
///
/// t is Student's of Σ(h − 1) degrees of freedom; the check holds the mean d and an error by which
/// it is as many normal deviations as t is unlikely. Noise with a colour scatters the blocks, and
/// is so far allowed for.
///
/// Valid:  six blocks before contact and more, no filter of a class applied to the record; nothing
///         otherwise.
/// Limit:  nothing where noise alone is before the contact
///         -> test ForceBeforeTouchTest.OfNoiseItIsWithinItsError;
///         a pull that falls off over a few contacts' approach is seen
///         -> test ForceBeforeTouchTest.SeesAPullAtADistance.
std::optional<DataCheck> force_before_touch(const Dataset& dataset);

}  // namespace rebound
