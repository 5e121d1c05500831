#include "comparisons/io/dataset/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <system_error>

#include "comparisons/io/laboratory/text_lines.hpp"
#include "comparisons/io/text.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr std::size_t most_rows = 10'000'000;

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  for (;;) {
    const auto comma = line.find(',');
    fields.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

class CsvReader {
 public:
  explicit CsvReader(const std::filesystem::path& file) : lines_(file) {}

  CsvTable read(const CsvRequest& request) {
    increasing_ = request.increasing;
    std::string_view line;
    if (!next_line(line)) refuse("the file is empty; a header row is needed");
    read_header(line, request);
    while (next_line(line)) read_row(line);
    if (table_.columns.front().size() > 1 && unfinished_row_) leave_out_last_row();
    if (table_.columns.front().empty()) refuse("there are no rows below the header");
    return std::move(table_);
  }

 private:
  [[noreturn]] void refuse(const std::string& reason, const std::string& column = {},
                           std::string_view value = {}, const std::string& allowed = {}) const {
    lines_.refuse(reason, column, value, allowed);
  }

  /// The next line that is neither empty nor a comment; false at the end.
  bool next_line(std::string_view& line) {
    while (lines_.next(line))
      if (!trimmed(line).empty() && !trimmed(line).starts_with('#')) return true;
    return false;
  }

  void read_header(std::string_view line, const CsvRequest& request) {
    for (const std::string_view field : fields_of(line)) header_.emplace_back(field);
    const auto take = [&](const std::string& wanted) {
      const auto found = std::find(header_.begin(), header_.end(), wanted);
      if (found == header_.end()) return false;
      if (std::find(found + 1, header_.end(), wanted) != header_.end())
        refuse("the column stands twice", wanted);
      table_.names.push_back(wanted);
      table_.columns.emplace_back();
      positions_.push_back(static_cast<std::size_t>(found - header_.begin()));
      return true;
    };
    for (const std::string& wanted : request.needed)
      if (!take(wanted))
        refuse("the column is missing", wanted, line, fmt::format("a header with {}", wanted));
    for (const std::string& wanted : request.optional) take(wanted);
  }

  void read_row(std::string_view line) {
    const auto fields = fields_of(line);
    if (fields.size() != header_.size())
      refuse(fmt::format("the row has {} fields, the header {}{}", fields.size(), header_.size(),
                         lines_.is_unfinished() ? "; was the last line cut off?" : ""),
             "", line);
    if (table_.columns.front().size() == most_rows)
      refuse(fmt::format("the file has more than {} rows", most_rows));
    for (std::size_t i = 0; i < positions_.size(); ++i)
      table_.columns[i].push_back(number(fields[positions_[i]], table_.names[i]));
    for (std::size_t i = 0; i < positions_.size(); ++i)
      if (table_.names[i] == increasing_) need_increase(table_.columns[i], fields[positions_[i]]);
    unfinished_row_ = lines_.is_unfinished();
  }

  void need_increase(const std::vector<double>& column, std::string_view field) const {
    const std::size_t n = column.size();
    if (n > 1 && !(column[n - 1] > column[n - 2]))
      refuse("the column does not increase", increasing_, field,
             fmt::format("a value above {:.9g}, that of the row before", column[n - 2]));
  }

  void leave_out_last_row() {
    for (auto& column : table_.columns) column.pop_back();
    table_.left_out_line = lines_.number();
  }

  double number(std::string_view field, const std::string& column) const {
    std::string_view digits = field;
    if (digits.starts_with('+')) digits.remove_prefix(1);
    double value = 0.0;
    const auto end = digits.data() + digits.size();
    const auto [stop, status] = std::from_chars(digits.data(), end, value);
    if (status != std::errc{} || stop != end)
      refuse(lines_.is_unfinished() ? "this is no number; was the last line cut off?"
                                    : "this is no number",
             column, field, "a number with a decimal point");
    if (!std::isfinite(value)) refuse("the number must be finite", column, field);
    return value;
  }

  TextLines lines_;
  bool unfinished_row_ = false;  // the last row had no line end
  std::string increasing_;
  std::vector<std::string> header_;
  std::vector<std::size_t> positions_;
  CsvTable table_;
};

}  // namespace

const std::vector<double>* CsvTable::column(const std::string& name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? nullptr : &columns[static_cast<std::size_t>(found - names.begin())];
}

CsvTable read_csv(const std::filesystem::path& file, const CsvRequest& request) {
  return CsvReader(file).read(request);
}

}  // namespace rebound
