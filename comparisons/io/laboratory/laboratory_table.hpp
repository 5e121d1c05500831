#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/io/laboratory/laboratory_units.hpp"
#include "comparisons/io/laboratory/table_dialect.hpp"

namespace rebound {

/// A column that is wanted of a table.
struct WantedColumn {
  std::string heading;              ///< as written in the file, or without its unit
  std::vector<Dimension> accepted;  ///< one of them; empty: the column is text
  bool increases = false;           ///< every number above that of the row before
  std::string unit{};               ///< of a heading that states none
  bool is_optional = false;         ///< its numbers stay empty where the table does not have it
};

struct ReadColumn {
  ColumnHeading heading;
  Dimension dimension;               ///< which of the accepted ones
  std::vector<double> numbers{};     ///< [SI]
  std::vector<std::string> texts{};  ///< of a text column
};

struct LaboratoryTable {
  TableDialect dialect;
  std::vector<ReadColumn> columns;  ///< as they were wanted
  std::vector<int> lines;           ///< of the rows
  int left_out_line = 0;            ///< of a last row that may be cut off; 0: none was left out
  std::size_t rows_read = 0;        ///< of which `lines` are kept
};

/// Which rows are kept of a table that may be longer than the memory.
struct KeptRows {
  std::size_t column = 0;             ///< of the wanted ones, whose largest swing is looked for
  std::size_t before = 0, after = 0;  ///< that many rows around it
};

/// Reads columns of a table as a laboratory writes it; of MATLAB and HDF5 files, by their names,
/// as read_array_table() does.
///
/// Accepted: comma, semicolon or tabulator; decimal point or comma; byte order mark; LF or CRLF;
///           comments (#, %, //) and other lines above the heading; units in the heading or in a
///           row of their own below it; further columns, text among them; quoted fields.
/// The heading is the first line that holds all wanted columns. A number is taken to SI by the
/// unit of its column; a column of a dimension without a unit is refused, but for plain numbers.
/// A last row without a line end is left out: it may have been cut inside a number.
/// Memory: the columns asked for and one line; at most 10^7 rows and 4096 columns. With `kept` that
///         of its rows, of any number (row_window.hpp); MATLAB and HDF5 files are read whole.
/// Errors: Error(bad_input) with file, line, column and the heading for a heading that is missing,
///         stands twice or has another unit, rows of another length, text or nothing where a
///         number is needed, what is not finite, a mix of decimal marks, numbers that do not
///         increase; Error(input_output_failed) when the file cannot be read.
LaboratoryTable read_laboratory_table(const std::filesystem::path& file,
                                      const std::vector<WantedColumn>& wanted,
                                      const std::optional<KeptRows>& kept = {});

/// What stands in a table, before anyone says which columns are wanted.
struct TablePreview {
  TableDialect dialect;
  std::vector<ColumnHeading> headings;
  std::vector<bool> is_number;  ///< of every column: is all of it numbers?
  std::vector<int> columns_at;  ///< where each heading starts in its line, from 1
  int heading_line = 0;         ///< 0: the file has no lines, but variables
  std::size_t rows = 0;
};

/// Looks for the heading: the first line of two fields or more, none of them a number, that is
/// followed by a row of as many fields with a number among them, or by a row of units and such a
/// row. Errors: Error(bad_input) where there is none; Error(input_output_failed).
TablePreview preview_table(const std::filesystem::path& file);

}  // namespace rebound
