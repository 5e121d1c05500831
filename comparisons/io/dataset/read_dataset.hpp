#pragma once

#include <filesystem>

#include "comparisons/io/dataset/dataset.hpp"

namespace rebound {

/// Reads a data-set folder: its dataset.toml and the CSV files it names.
///
/// Traces and tables are read as a laboratory writes them (laboratory_table.hpp): units in the
/// headings, an acceleration times the mass as a force (trace_channels.hpp). Speed and restitution
/// may stand as light gates, heights or flight times (shot_readings.hpp), one shot a row of a table
/// (`[[shot_table]]`); what the air does is told among the notes.
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
