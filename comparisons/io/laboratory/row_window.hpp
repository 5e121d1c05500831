#pragma once

#include <cstddef>
#include <optional>

#include "comparisons/io/laboratory/laboratory_table.hpp"

namespace rebound {

/// What is kept of the record of an impact, around its largest force.
constexpr KeptRows rows_of_a_record(std::size_t force_column) {
  return {.column = force_column, .before = 400'000, .after = 200'000};
}

/// Of a table of any length, keeps the rows around the largest swing of one column from its first
/// number, while the table is read.
///
/// Memory: two and a half times what is kept, whatever the length of the file.
/// Limit:  a table that is shorter than the window stays as it is
///         -> test RowWindowTest.KeepsTheRowsAroundTheLargestSwing
class RowWindow {
 public:
  explicit RowWindow(const KeptRows& kept) : kept_(kept) {}

  /// After each row that was put to the end of `table`.
  void added(LaboratoryTable& table);
  /// After the last one.
  void finish(LaboratoryTable& table);

 private:
  void keep_last(LaboratoryTable& table, std::size_t rows) const;

  KeptRows kept_;
  std::optional<LaboratoryTable> found_;  ///< the window, where the rows go on beyond it
  std::size_t rows_ = 0, peak_ = 0;       ///< read so far; number of that of the largest swing
  double first_ = 0.0, swing_ = -1.0;
};

}  // namespace rebound
