#pragma once

#include <filesystem>

#include "comparisons/io/dataset/dataset.hpp"

namespace rebound {

/// Writes dataset.toml and, before it, the traces it names, each file
/// atomically: where dataset.toml stands, the rest is complete.
///
/// Limit:  reads back to the same numbers -> test WriteDatasetTest.RoundTrip.
/// Errors: Error(input_output_failed).
void write_dataset(const Dataset& dataset, const std::filesystem::path& folder);

}  // namespace rebound
