#pragma once

#include "comparisons/inference/calibration/calibration_file.hpp"
#include "comparisons/inference/selection/selection.hpp"

namespace rebound {

/// What `rebound select FILE` reads.
struct SelectionFile {
  std::vector<Candidate> candidates;
  LawCalibrationOptions options;
  std::vector<ReferenceFolder> references;
};

void describe(Visitor& visit, Candidate& candidate);
void describe(Visitor& visit, SelectionFile& file);

}  // namespace rebound
