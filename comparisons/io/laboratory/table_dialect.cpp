#include "comparisons/io/laboratory/table_dialect.hpp"

#include <algorithm>
#include <charconv>
#include <system_error>

#include "comparisons/io/text.hpp"

namespace rebound {

char separator_of(std::string_view heading) {
  std::string plain;
  bool quoted = false;
  for (const char sign : heading) {
    if (sign == '"') quoted = !quoted;
    if (!quoted) plain += sign;
  }
  for (const char separator : {'\t', ';'})
    if (plain.find(separator) != std::string::npos) return separator;
  return ',';
}

std::vector<std::string_view> split_fields(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  for (;;) {
    std::string_view ahead = line;
    if (separator != '\t') {  // a quote may have blanks before it
      const auto first = ahead.find_first_not_of(" \t");
      ahead.remove_prefix(first == std::string_view::npos ? 0 : first);
    }
    const auto close = ahead.starts_with('"') ? ahead.find('"', 1) : std::string_view::npos;
    const auto from = close == std::string_view::npos
                          ? 0
                          : static_cast<std::size_t>(ahead.data() - line.data()) + close;
    const auto end = line.find(separator, from);
    const std::string_view whole = line.substr(0, end);
    const auto inside = whole.find_first_not_of(separator == '\t' ? " " : " \t");
    std::string_view field =
        inside == std::string_view::npos ? whole.substr(whole.size()) : trimmed(whole);
    if (field.size() >= 2 && field.starts_with('"') && field.ends_with('"'))
      field = field.substr(1, field.size() - 2);
    fields.push_back(field);
    if (end == std::string_view::npos) return fields;
    line.remove_prefix(end + 1);
  }
}

namespace {

std::optional<double> plain_number(std::string_view digits) {
  double value = 0.0;
  const char* end = digits.data() + digits.size();
  const auto [stop, status] = std::from_chars(digits.data(), end, value);
  if (digits.empty() || status != std::errc{} || stop != end) return std::nullopt;
  return value;
}

}  // namespace

std::optional<double> number_in(std::string_view field, TableDialect& dialect) {
  std::string_view digits = trimmed(field);
  if (digits.starts_with('+')) digits.remove_prefix(1);
  const auto comma = digits.find(',');
  const bool point = digits.find('.') != std::string_view::npos;
  std::optional<double> value;
  if (comma != std::string_view::npos) {
    if (point || dialect.separator == ',' || (dialect.mark_seen && dialect.decimal_mark == '.'))
      return std::nullopt;
    std::string pointed(digits);
    pointed[comma] = '.';
    value = plain_number(pointed);
  } else {
    if (point && dialect.mark_seen && dialect.decimal_mark == ',') return std::nullopt;
    value = plain_number(digits);
  }
  if (value && (comma != std::string_view::npos || point)) {
    dialect.decimal_mark = comma != std::string_view::npos ? ',' : '.';
    dialect.mark_seen = true;
  }
  return value;
}

bool is_passed_over(std::string_view line) {
  const std::string_view text = trimmed(line);
  return text.empty() || text.starts_with('#') || text.starts_with('%') || text.starts_with("//");
}

}  // namespace rebound
