#pragma once

#include <string>
#include <vector>

#include "comparisons/inference/calibration/law_calibration.hpp"
#include "comparisons/io/toml/document.hpp"
#include "comparisons/io/toml/visitor.hpp"

namespace rebound {

/// A folder with references: a data set or a result.
struct ReferenceFolder {
  std::string folder;  ///< relative to the file that names it
};

/// What `rebound calibrate FILE` reads.
struct CalibrationFile {
  LawRequest request;
  LawCalibrationOptions options;
  std::vector<ReferenceFolder> references;
};

void describe(Visitor& visit, ReferenceFolder& reference);
void describe(Visitor& visit, Nuisances& nuisances);
/// Starts, seed, confidence, loss and profiles: what any tier's search is asked for.
void describe_search(Visitor& visit, CalibrationControls& controls);
void describe(Visitor& visit, CalibrationFile& file);

/// The shots of all references of a file, each with its label.
/// Errors: those of read_references and read_scalar_references.
std::vector<MeasuredImpact> references_of(const Document& document, const CalibrationFile& file);

/// The members of a request, without a table of their own.
void describe_law_request(Visitor& visit, LawRequest& request);

}  // namespace rebound
