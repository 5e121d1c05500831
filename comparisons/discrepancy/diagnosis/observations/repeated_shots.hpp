#pragma once

#include <vector>

#include "comparisons/discrepancy/diagnosis/fits/joint_model.hpp"

namespace rebound {

/// Shots of one ball at nearly one speed need no impact each: between two impacts that are one per
/// cent apart in speed, every column of a trace and every scalar is a straight line in speed, and
/// what it misses is the curvature, ε² n(n−1)/2 for a force that grows as vⁿ: 5e-5 at ε = 2 %
/// -> test RepeatedShotsTest.AShotBetweenTwoSpeedsIsTheirLine.
///
/// The first shot of each group, for every shot; a shot that shares with none is its own.
/// Groups of less than three are none: they would save nothing.
std::vector<std::size_t> shots_that_share(const Observations& seen, const LumpedModel& believed);

/// a + share (b − a), column by column and scalar by scalar.
ModelledImpact between(const ModelledImpact& a, const ModelledImpact& b, double share);

}  // namespace rebound
