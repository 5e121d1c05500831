#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rebound {

/// What a CSV file must and may hold.
struct CsvRequest {
  std::vector<std::string> needed;    ///< columns, by their header
  std::vector<std::string> optional;  ///< further columns that are wanted when there
  std::string increasing{};           ///< the column that must strictly increase, if any
};

/// Numbers of a CSV file, one vector per column asked for.
struct CsvTable {
  std::vector<std::string> names;  ///< those of the request that the file has
  std::vector<std::vector<double>> columns;
  /// Line number of a last row that was left out, 0 when none was.
  int left_out_line = 0;

  /// A column of the request; nullptr when the file does not have it.
  const std::vector<double>* column(const std::string& name) const;
};

/// Reads a comma-separated file line by line: a header row, then numbers.
///
/// Accepted: byte order mark, LF or CRLF, blanks around fields, comment lines
/// starting with '#', columns beyond those asked for.
/// A last row without a line end may have been cut off inside a number, which
/// nothing would show: it is left out and its line reported.
/// Memory: the numbers asked for and one line; at most 10^7 rows.
/// Errors: Error(bad_input) with file and line for a missing or duplicate
///         column, a row of another length, text that is not a finite number,
///         a decimal comma, a column that does not increase, NUL, a line of more than 64 kB, no
///         rows; Error(input_output_failed) when the file cannot be read.
CsvTable read_csv(const std::filesystem::path& file, const CsvRequest& request);

}  // namespace rebound
