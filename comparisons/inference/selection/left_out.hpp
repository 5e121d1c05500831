#pragma once

#include "comparisons/inference/selection/selection.hpp"

namespace rebound {

/// Fits a candidate to all speeds but one, for each speed in turn, and scores
/// its prediction of the one. Nothing is filled in with a single speed.
void predict_left_out(const Candidate& candidate, const std::vector<MeasuredImpact>& references,
                      const LawCalibrationOptions& options, const RunControl& control,
                      CandidateScore& score);

}  // namespace rebound
