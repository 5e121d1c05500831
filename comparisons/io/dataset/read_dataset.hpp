#pragma once

#include <filesystem>

#include "comparisons/io/dataset/dataset.hpp"

namespace rebound {

/// Reads a data-set folder: its dataset.toml and the CSV files it names.
///
/// Traces may not leave the folder: absolute paths, `..` and symbolic links
/// to the outside are refused. Time must strictly increase; the deflection of
/// a compression need not, since it may hold the way back. A shot without trace and scalars, a
/// compression without trace and stiffness, an uncertainty without its value, and an implied
/// density outside 50–20000 kg/m³ are refused.
///
/// Errors: Error(bad_input) with file, line and key; Error(input_output_failed)
/// for a file that cannot be read.
Dataset read_dataset(const std::filesystem::path& folder);

}  // namespace rebound
