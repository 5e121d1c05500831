#pragma once

#include <cstddef>
#include <vector>

#include "comparisons/io/dataset/contact_window.hpp"

namespace rebound {

/// The contact with the pull of a ball that sticks.
///
///   contact    where the force pushes, with its onset and its end, samples of `force`
///   force      a whole record [N]
///   rounding   standard deviation of its rounding [N]
///
/// A pull outlasts what a push takes to end by far. Means over blocks of a twentieth of the contact
/// that lie below zero by three deviations of the quiet are a pull, from a quarter of the contact
/// after its end on, as far as they go on without a break and for one contact at most; the same
/// before first touch, where a ball is drawn in before it pushes.
///
/// Caution: an amplifier's undershoot is taken for a pull. It is kept for the fits, which tell
///          both apart.
/// Valid:   records that go on for twice as long as the pull; in shorter ones it is not told from a
///          plate that swings back, and stays out.
/// Limit:   a plate that rings comes back above zero before as long again, and stays out
///          -> test PullInRecordTest.ARingIsNone. A record without a pull is unchanged
///          -> test PullInRecordTest.ThereIsNoneInAPush.
SampleRange with_pull(SampleRange contact, const std::vector<double>& force, double rounding);

}  // namespace rebound
