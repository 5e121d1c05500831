#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rebound {

/// How the fields of a table stand in its lines.
struct TableDialect {
  char separator = ',';     ///< ',', ';' or tabulator
  char decimal_mark = '.';  ///< '.' or ','; ',' never beside the separator ','
  bool mark_seen = false;   ///< a number with a mark was read: from now on it must be this one
};

/// The separator of a heading: a tabulator where it has one, else a semicolon, else a comma.
/// Quoted text does not count.
char separator_of(std::string_view heading);

/// Fields of a line without the blanks around them; a field in double quotes may hold the
/// separator, and loses its quotes.
std::vector<std::string_view> split_fields(std::string_view line, char separator);

/// The number that a whole field holds, with a decimal point or, where the separator allows it and
/// no number before had a point, a decimal comma; nothing for other text. NaN and Inf are numbers.
std::optional<double> number_in(std::string_view field, TableDialect& dialect);

/// Empty, or a comment that starts with '#' or '%' or "//".
bool is_passed_over(std::string_view line);

}  // namespace rebound
