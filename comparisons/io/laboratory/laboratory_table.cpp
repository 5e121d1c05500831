#include "comparisons/io/laboratory/laboratory_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "comparisons/io/laboratory/array_table.hpp"
#include "comparisons/io/laboratory/row_window.hpp"
#include "comparisons/io/laboratory/table_headings.hpp"
#include "comparisons/io/laboratory/text_lines.hpp"

namespace rebound {
namespace {

constexpr std::size_t longest_table = 10'000'000;

class TableReader {
 public:
  TableReader(const std::filesystem::path& file, const std::vector<WantedColumn>& wanted,
              const std::optional<KeptRows>& kept)
      : lines_(file), wanted_(wanted) {
    if (kept) window_.emplace(*kept);
  }

  LaboratoryTable read() {
    find_heading();
    std::string_view line;
    while (lines_.next(line))
      if (!is_passed_over(line)) read_row(line);
    if (table_.lines.empty()) lines_.refuse("there are no rows below the heading");
    const bool ends_with_last = table_.lines.back() == last_line_;
    if (table_.lines.size() > 1 && unfinished_row_ && ends_with_last) leave_out_last_row();
    if (window_)
      window_->finish(table_);
    else
      table_.rows_read = table_.lines.size();
    return std::move(table_);
  }

 private:
  void find_heading() {
    const FoundHeading found = find_wanted(lines_, wanted_);
    table_.dialect.separator = found.separator;
    headings_ = found.headings;
    positions_ = found.positions;
    units_open_ = true;
    for (std::size_t i = 0; i < wanted_.size(); ++i) {
      const bool there = positions_[i] != no_position;
      table_.columns.push_back(
          {.heading = there ? headings_[positions_[i]] : ColumnHeading{}, .dimension = {}});
    }
    heading_line_ = lines_.number();
  }

  /// Settles the unit of every column, once it is known whether a row of units follows.
  void settle_units(const std::vector<std::string_view>* units) {
    factors_.clear();
    for (std::size_t i = 0; i < wanted_.size(); ++i) {
      ReadColumn& column = table_.columns[i];
      factors_.push_back(1.0);
      if (positions_[i] == no_position) continue;
      if (units && column.heading.unit.empty())
        column.heading.unit = unit_of_row((*units)[positions_[i]]);
      if (column.heading.unit.empty()) column.heading.unit = wanted_[i].unit;
      factors_.back() = accepted_factor(lines_.name(), wanted_[i], column, heading_line_);
    }
    units_open_ = false;
  }

  void read_row(std::string_view line) {
    const auto fields = split_fields(line, table_.dialect.separator);
    if (units_open_) {
      const bool units = is_row_of_units(fields, headings_.size());
      settle_units(units ? &fields : nullptr);
      if (units) return;
    }
    // Trailing separators, as spreadsheets write them, are no fields.
    if (fields.size() != headings_.size() && !only_empty_beyond(fields, headings_.size()))
      refuse_length(line, fields.size());
    if (!window_ && table_.lines.size() == longest_table)
      lines_.refuse(fmt::format("the file has more than {} rows", longest_table));
    for (std::size_t i = 0; i < wanted_.size(); ++i) {
      if (positions_[i] == no_position) continue;
      const std::string_view field = fields[positions_[i]];
      ReadColumn& column = table_.columns[i];
      if (wanted_[i].accepted.empty()) {
        column.texts.emplace_back(field);
        continue;
      }
      column.numbers.push_back(factors_[i] * number(field, column.heading.text));
      if (wanted_[i].increases) need_increase(column, field);
    }
    table_.lines.push_back(lines_.number());
    last_line_ = lines_.number();
    if (window_) window_->added(table_);
    unfinished_row_ = lines_.is_unfinished();
  }

  [[noreturn]] void refuse_length(std::string_view line, std::size_t fields) const {
    const bool commas = table_.dialect.separator == ',' && fields == 2 * headings_.size();
    lines_.refuse(fmt::format("the row has {} fields, the heading in line {} has {}{}", fields,
                              heading_line_, headings_.size(),
                              commas                   ? "; are these decimal commas? Then the "
                                                         "fields must be parted by semicolons or "
                                                         "tabulators"
                              : lines_.is_unfinished() ? "; was the last line cut off?"
                                                       : ""),
                  "", line);
  }

  double number(std::string_view field, const std::string& heading) {
    const bool decimal_known = table_.dialect.mark_seen;
    const auto value = number_in(field, table_.dialect);
    if (!value) {
      const std::string cut = lines_.is_unfinished() ? "; was the last line cut off?" : "";
      if (field.empty()) lines_.refuse("a number is missing here" + cut, heading, field);
      lines_.refuse("this is no number" + cut, heading, field,
                    table_.dialect.separator == ','
                        ? "a number with a decimal point"
                        : fmt::format("a number with a decimal {}{}",
                                      table_.dialect.decimal_mark == ',' ? "comma" : "point",
                                      decimal_known ? ", as in the rows above" : " or comma"));
    }
    if (!std::isfinite(*value)) lines_.refuse("the number must be finite", heading, field);
    return *value;
  }

  void need_increase(const ReadColumn& column, std::string_view field) const {
    const std::size_t n = column.numbers.size();
    if (n > 1 && !(column.numbers[n - 1] > column.numbers[n - 2]))
      lines_.refuse("the column does not increase", column.heading.text, field,
                    fmt::format("a value above that of the row before, {:.9g}",
                                column.numbers[n - 2] / factor_of(column)));
  }

  double factor_of(const ReadColumn& column) const {
    return factors_[static_cast<std::size_t>(&column - table_.columns.data())];
  }

  void leave_out_last_row() {
    for (ReadColumn& column : table_.columns) {
      if (!column.numbers.empty()) column.numbers.pop_back();
      if (!column.texts.empty()) column.texts.pop_back();
    }
    table_.left_out_line = table_.lines.back();
    table_.lines.pop_back();
  }

  TextLines lines_;
  const std::vector<WantedColumn>& wanted_;
  LaboratoryTable table_;
  std::vector<ColumnHeading> headings_;
  std::vector<std::size_t> positions_;
  std::vector<double> factors_;
  int heading_line_ = 0;
  bool units_open_ = false;
  bool unfinished_row_ = false;
  int last_line_ = 0;
  std::optional<RowWindow> window_;
};

}  // namespace

LaboratoryTable read_laboratory_table(const std::filesystem::path& file,
                                      const std::vector<WantedColumn>& wanted,
                                      const std::optional<KeptRows>& kept) {
  return is_array_file(file) ? read_array_table(file, wanted)
                             : TableReader(file, wanted, kept).read();
}

}  // namespace rebound
