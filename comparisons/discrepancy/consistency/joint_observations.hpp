#pragma once

#include <vector>

#include "comparisons/inference/calibration/observations.hpp"

namespace rebound {

/// Impacts of several balls as one set of data: the balls and shots of each in the order given.
/// A name that two balls share gets the number of the ball behind it, and so do labels of shots.
///
/// Valid:   scalars; histories keep their noise, and slow compressions and blocks are left out.
/// Limit:   shots come back as they were, each with its own ball
///          -> test JointScalarsTest.BallsTogetherKeepTheirShots.
Observations balls_together(const std::vector<const Observations*>& apart);

}  // namespace rebound
