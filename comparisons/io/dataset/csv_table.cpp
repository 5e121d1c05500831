#include "comparisons/io/dataset/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <string_view>
#include <system_error>

#include "comparisons/io/text.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr std::size_t longest_line = 65536;
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
  explicit CsvReader(const std::filesystem::path& file)
      : name_(file.string()), stream_(file, std::ios::binary), line_(longest_line + 2, '\0') {
    std::error_code status;
    if (!stream_ || std::filesystem::is_directory(file, status))
      throw Error(ExitCode::input_output_failed, "the file cannot be opened", {.file = name_});
  }

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
    throw Error(ExitCode::bad_input, reason,
                {.file = name_,
                 .line = number_,
                 .column = 0,
                 .key = column,
                 .value = std::string(value.substr(0, 80)),
                 .allowed = allowed});
  }

  /// The next line that is neither empty nor a comment; false at the end.
  bool next_line(std::string_view& line) {
    for (;;) {
      // A bounded read: a line without an end must not fill the memory.
      stream_.getline(line_.data(), static_cast<std::streamsize>(line_.size()));
      auto length = static_cast<std::size_t>(stream_.gcount());
      if (stream_.bad())
        throw Error(ExitCode::input_output_failed, "the file cannot be read", {.file = name_});
      if (stream_.eof() && length == 0) return false;
      ++number_;
      if (stream_.fail()) refuse(fmt::format("the line is longer than {} bytes", longest_line));
      if (stream_.eof())
        unfinished_ = true;
      else
        --length;  // the line end was counted
      line = std::string_view(line_).substr(0, length);
      if (number_ == 1 && line.starts_with("\xef\xbb\xbf")) line.remove_prefix(3);
      if (line.ends_with('\r')) line.remove_suffix(1);
      if (line.find('\0') != std::string_view::npos) refuse("the line holds a NUL byte");
      if (!trimmed(line).empty() && !trimmed(line).starts_with('#')) return true;
      if (unfinished_) return false;
    }
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
                         unfinished_ ? "; was the last line cut off?" : ""),
             "", line);
    if (table_.columns.front().size() == most_rows)
      refuse(fmt::format("the file has more than {} rows", most_rows));
    for (std::size_t i = 0; i < positions_.size(); ++i)
      table_.columns[i].push_back(number(fields[positions_[i]], table_.names[i]));
    for (std::size_t i = 0; i < positions_.size(); ++i)
      if (table_.names[i] == increasing_) need_increase(table_.columns[i], fields[positions_[i]]);
    unfinished_row_ = unfinished_;
  }

  void need_increase(const std::vector<double>& column, std::string_view field) const {
    const std::size_t n = column.size();
    if (n > 1 && !(column[n - 1] > column[n - 2]))
      refuse("the column does not increase", increasing_, field,
             fmt::format("a value above {:.9g}, that of the row before", column[n - 2]));
  }

  void leave_out_last_row() {
    for (auto& column : table_.columns) column.pop_back();
    table_.left_out_line = number_;
  }

  double number(std::string_view field, const std::string& column) const {
    std::string_view digits = field;
    if (digits.starts_with('+')) digits.remove_prefix(1);
    double value = 0.0;
    const auto end = digits.data() + digits.size();
    const auto [stop, status] = std::from_chars(digits.data(), end, value);
    if (status != std::errc{} || stop != end)
      refuse(unfinished_ ? "this is no number; was the last line cut off?" : "this is no number",
             column, field, "a number with a decimal point");
    if (!std::isfinite(value)) refuse("the number must be finite", column, field);
    return value;
  }

  std::string name_;
  std::ifstream stream_;
  std::string line_;
  int number_ = 0;
  bool unfinished_ = false;      // the line at hand has no line end
  bool unfinished_row_ = false;  // and it was a row
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
