#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/io/report/figure.hpp"

namespace rebound::report {

/// A cell as text, with a verdict where it has one. A verdict is shown by colour
/// and by a sign, never by colour alone.
struct TableCell {
  enum class Verdict { none, good, doubtful, bad };
  std::string text;
  Verdict verdict = Verdict::none;
  std::optional<Origin> origin;  ///< where the column does not say it for all
  std::string link = {};         ///< page beside this one, e.g. "diagnosis/core-A.html"; or empty
};

struct TableColumn {
  enum class Kind { text, number };  ///< numbers are set flush right
  std::string name;
  std::string unit;  ///< empty for text; "1" is dimensionless
  Kind kind = Kind::text;
  std::optional<Origin> origin;
};

struct Table {
  std::string title;
  std::string caption;
  std::vector<TableColumn> columns;
  std::vector<std::vector<TableCell>> rows;  ///< each with one cell per column
};

/// A cell of plain text.
TableCell text_cell(const std::string& text, TableCell::Verdict verdict = TableCell::Verdict::none);

/// `value` with that many significant digits, e.g. (0.52731, 3) -> "0.527"; whole
/// numbers below a million keep their digits before the point.
/// Errors: a value that is not finite, or digits outside 1..17.
TableCell number_cell(double value, int significant_digits);

/// "value ± half-width" with two digits of the half-width, e.g. (0.52731, 0.0123) ->
/// "0.527 ± 0.012". Errors: not finite, or half_width <= 0.
TableCell uncertain_cell(double value, double half_width);

}  // namespace rebound::report
