#pragma once

#include <string>
#include <vector>

#include "comparisons/inference/calibration/calibration_file.hpp"

namespace rebound {

/// One row asked for: an impact file whose [model] is taken as it is, or a law
/// that is first calibrated to the references.
struct BenchmarkRow {
  std::string label;
  std::string file;    ///< lumped impact file, relative; empty: calibrate
  LawRequest request;  ///< when there is no file
};

/// What `rebound benchmark FILE` reads.
struct BenchmarkFile {
  std::vector<BenchmarkRow> rows;
  std::vector<ReferenceFolder> references;
};

void describe(Visitor& visit, BenchmarkRow& row);
void describe(Visitor& visit, BenchmarkFile& file);

}  // namespace rebound
