#pragma once

#include <filesystem>
#include <vector>

#include "comparisons/io/dataset/measured_impact.hpp"

namespace rebound {

/// References in a folder, each the contact alone: the shots of a data set (dataset.toml) that have
/// a trace, or the one impact of a result folder (result.json, trace.csv, effective.toml),
/// whichever the folder is.
///
/// Labels are "<data set or folder> <speed> m/s".
/// Errors: Error(bad_input) for a folder that is neither, a data set without
///         traces, or contents out of range; Error(input_output_failed) for
///         what cannot be read; Error(corrupt_store) for a result folder whose
///         files do not belong together.
std::vector<MeasuredImpact> read_references(const std::filesystem::path& folder);

/// Shots of a data set that state a scalar with its uncertainty, whether they have a trace or not.
/// What a trace says is not among their scalars.
/// Errors: Error(bad_input) for a folder that is no data set, or where no shot states one.
std::vector<MeasuredImpact> read_scalar_references(const std::filesystem::path& folder);

}  // namespace rebound
