#pragma once

#include <optional>
#include <string>
#include <vector>

namespace rebound::report {

/// One cell: colour and number. Without a value it says why in `text`.
struct MatrixCell {
  std::optional<double> value;
  std::string text;       ///< the number as shown, or why there is none
  bool hatched = false;   ///< the matrix's `hatching` says what this means
  std::string overlay;    ///< key of the overlay a click shows; empty: the cell is not a link
  std::string highlight;  ///< name of the series to bring forward there; may be empty
};

/// A column, e.g. 15 m/s in the group "core A". Neighbours of one group share a heading.
struct MatrixColumn {
  std::string group;
  std::string name;
};

struct MatrixRow {
  std::string name;
  std::vector<MatrixCell> cells;  ///< one per column
};

/// How values become colours: 0 is pale, `limit` and beyond the darkest.
struct ColourScale {
  enum class Kind { sequential, diverging } kind = Kind::sequential;
  double limit = 1.0;
};

/// A heat map whose cells carry their numbers, and lead to overlays.
struct Matrix {
  std::string title;
  std::string caption;
  std::string quantity;     ///< what the values are, e.g. "error of the contact time"
  std::string unit;         ///< "1" is dimensionless
  std::string row_heading;  ///< e.g. "law"
  std::string hatching;     ///< what a hatched cell means; required where one is hatched
  ColourScale scale;
  std::string overlays;  ///< id of the Overlays block the cells lead to; may be empty
  std::vector<MatrixColumn> columns;
  std::vector<MatrixRow> rows;
};

}  // namespace rebound::report
