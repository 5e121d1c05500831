#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "comparisons/io/laboratory/laboratory_table.hpp"
#include "comparisons/io/laboratory/text_lines.hpp"

/// Which line is the heading of a table, and in which units its columns are.
namespace rebound {

inline constexpr auto no_position = static_cast<std::size_t>(-1);

struct FoundHeading {
  char separator = ',';
  std::vector<ColumnHeading> headings;
  std::vector<std::size_t> positions;  ///< of the wanted columns; no_position: not there
};

/// Reads up to the first line that holds all wanted headings, as written or without their unit.
/// Errors: Error(bad_input) for a heading that is missing, or that two columns have.
FoundHeading find_wanted(TextLines& lines, const std::vector<WantedColumn>& wanted);

/// Is every field a unit or empty, and one of them a unit? "(ms)" and "[N]" are units, too.
bool is_row_of_units(const std::vector<std::string_view>& fields, std::size_t columns);

/// "(ms)" and "[ms]" without their brackets.
std::string unit_of_row(std::string_view field);

/// Are there at least so many fields, and only empty ones beyond?
bool only_empty_beyond(const std::vector<std::string_view>& fields, std::size_t columns);

/// One unit of the column in SI; sets its dimension. Line 0: the file has no lines.
/// Errors: Error(bad_input) for a unit that is missing, unknown or of another dimension.
double accepted_factor(const std::string& file, const WantedColumn& wanted, ReadColumn& column,
                       int heading_line);

}  // namespace rebound
