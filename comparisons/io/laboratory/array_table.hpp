#pragma once

#include <filesystem>
#include <vector>

#include "comparisons/io/array_files/interface.hpp"
#include "comparisons/io/laboratory/laboratory_table.hpp"

namespace rebound {

/// Does the name of a file say that it holds arrays: .mat, .h5, .hdf5, .hdf?
bool is_array_file(const std::filesystem::path& file);

/// Columns of a MATLAB or HDF5 file as read_laboratory_table() gives those of a text: a column is a
/// variable that is a vector of real numbers, named as in the file or without its unit ("force_kN",
/// or "force"). Its unit is that of an attribute "units" or "unit" of HDF5, of its name, or the
/// wanted column's.
///
/// Limit:  the same record as text and as arrays is the same -> test ArrayTableTest.
/// Errors: Error(bad_input) with file and variable for one that is missing, is no vector of
///         numbers, is longer or shorter than another, has another unit or none, holds what is not
///         finite or, of a time, does not increase (the element is named, counted from 1); for a
///         file that is damaged or of another kind; for a program built without these libraries.
///         Error(input_output_failed) when the file cannot be read.
LaboratoryTable read_array_table(const std::filesystem::path& file,
                                 const std::vector<WantedColumn>& wanted);

/// All variables as headings; numbers are those vectors that are as long as the longest one.
TablePreview preview_array_file(const std::filesystem::path& file);

/// Writes columns to an HDF5 file, under another name first, so that it is there whole or not at
/// all. Errors: Error(input_output_failed), Error(bad_input) for a program built without HDF5.
void write_array_table(const std::filesystem::path& file, const std::vector<ArrayColumn>& columns,
                       const std::vector<ArrayNote>& notes);

}  // namespace rebound
