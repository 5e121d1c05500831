#pragma once

#include <filesystem>
#include <string>

#include "comparisons/io/dataset/dataset.hpp"
#include "comparisons/io/toml/document.hpp"

/// The CSV files that a dataset.toml names.
namespace rebound {

/// A file in the folder of the document; links are followed, so that a link out of the folder is
/// seen as what it is.
/// Errors: Error(bad_input) at the key for a file outside; Error(input_output_failed) for none.
std::filesystem::path file_in_folder(const Document& document, const std::string& key,
                                     const std::string& written);

/// Adds to the notes that a last row without a line end was left out; line 0: none was.
void note_left_out_line(Dataset& dataset, const std::filesystem::path& file, int line);

/// Reads the trace of a shot by the channels of its data set; `key` is the shot's path.
void read_trace(const Document& document, Dataset& dataset, MeasuredImpact& shot,
                const std::string& key);

/// Reads the curve of a slow compression.
void read_curve(const Document& document, Dataset& dataset, std::size_t number);

/// Appends the rows of all tables to the shots.
///
/// A row is what is common to all, then its own columns. Relative uncertainties are applied once
/// the readings are settled. Rows are selected by text.
/// Errors: Error(bad_input) with the table's file and line for what a reader of a single shot would
///         refuse.
void read_shot_tables(const Document& document, Dataset& dataset);

/// Sets speed and restitution from what was read, and notes what the air does.
/// Errors: Error(bad_input) at `key`.
void settle_shot(const Document& document, const Dataset& dataset, MeasuredImpact& shot,
                 const std::string& key);

}  // namespace rebound
