#include "comparisons/io/laboratory/row_window.hpp"

#include <cmath>

namespace rebound {

void RowWindow::keep_last(LaboratoryTable& table, std::size_t rows) const {
  const auto cut = [rows](auto& column) {
    if (column.size() > rows)
      column.erase(column.begin(), column.end() - static_cast<std::ptrdiff_t>(rows));
  };
  for (ReadColumn& column : table.columns) {
    cut(column.numbers);
    cut(column.texts);
  }
  cut(table.lines);
}

void RowWindow::added(LaboratoryTable& table) {
  const double value = table.columns[kept_.column].numbers.back();
  if (rows_++ == 0) first_ = value;
  if (const double swing = std::abs(value - first_); swing > swing_) {
    swing_ = swing;
    peak_ = rows_;
    found_.reset();
  }
  if (!found_ && rows_ >= peak_ + kept_.after) {
    found_ = table;
    keep_last(*found_, kept_.before + kept_.after + 1);
    keep_last(table, kept_.before);
    return;
  }
  const std::size_t wanted = kept_.before + (found_ ? 0 : rows_ - peak_ + 1);
  if (table.lines.size() > wanted + kept_.before) keep_last(table, wanted);
}

void RowWindow::finish(LaboratoryTable& table) {
  const int left_out_line = table.left_out_line;
  if (found_)
    table = std::move(*found_);
  else
    keep_last(table, kept_.before + rows_ - peak_ + 1);
  table.left_out_line = left_out_line;
  table.rows_read = rows_ - (left_out_line == 0 ? 0 : 1);
}

}  // namespace rebound
