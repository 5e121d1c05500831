#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"
#include "comparisons/io/dataset/dataset.hpp"
#include "comparisons/io/toml/document.hpp"

namespace rebound {

/// The model that somebody believes, as a file gives it.
struct BelievedModel {
  LumpedModel model;
  std::optional<FemProblem> fem{};  ///< in place of `model`
  std::vector<EffectChoice> effects;
};

/// Reads [model] of an impact file; [sphere] and [impact] may be left out.
/// Where the file has a [sphere] and the data are of one ball, the two must be
/// the same ball within their stated uncertainties.
/// Errors: Error(bad_input) as any impact file, for another tier, or for a
///         sphere that is not that of the data.
BelievedModel read_believed_model(const Document& document, const std::vector<Dataset>& datasets);

/// A diagnosis of these data under the model that a file believes, of either tier; what else may be
/// asked is as by default.
/// Errors: as `read_believed_model`.
DiagnosisRequest request_for(const Document& document, std::vector<Dataset> datasets);

/// The model that a diagnosis ends with, as an impact file: numbers of one ball as fitted, effects
/// with their fitted sizes, the impact of the ball's first shot.
std::string extended_model_toml(const Diagnosis& diagnosis, std::size_t ball = 0);

}  // namespace rebound
