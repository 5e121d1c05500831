#include "comparisons/io/laboratory/table_headings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "comparisons/io/text.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr std::size_t most_columns = 4096;
constexpr int last_heading_line = 1000;

/// Fields of a line that may be a heading.
std::vector<ColumnHeading> headings_in(const TextLines& lines, std::string_view line,
                                       char separator) {
  const auto fields = split_fields(line, separator);
  if (fields.size() > most_columns)
    lines.refuse(
        fmt::format("the line has {} columns; {} are the most", fields.size(), most_columns));
  std::vector<ColumnHeading> headings;
  headings.reserve(fields.size());
  for (const std::string_view field : fields) headings.push_back(parse_heading(field));
  return headings;
}

/// Where a wanted heading stands: as written first, then by its name alone.
std::vector<std::size_t> places_of(const std::vector<ColumnHeading>& headings,
                                   const std::string& wanted) {
  std::vector<std::size_t> places;
  for (const auto part : {&ColumnHeading::text, &ColumnHeading::name}) {
    for (std::size_t i = 0; i < headings.size(); ++i)
      if (headings[i].*part == wanted) places.push_back(i);
    if (!places.empty()) break;
  }
  return places;
}

std::string listed(const std::vector<ColumnHeading>& headings) {
  constexpr std::size_t most = 12;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, headings.size()); ++i)
    text += (i == 0 ? "" : " | ") + headings[i].text;
  return headings.size() > most ? text + " | ..." : text;
}

std::string units_of(const std::vector<Dimension>& accepted) {
  std::string text;
  for (const Dimension& dimension : accepted)
    text += (text.empty() ? "" : " or ") +
            (same_dimension(dimension, dimension::none) ? "a plain number" : unit_name(dimension));
  return "a unit like " + text;
}

}  // namespace

FoundHeading find_wanted(TextLines& lines, const std::vector<WantedColumn>& wanted) {
  std::vector<ColumnHeading> most_like;
  std::string missing;
  int most_found = -1, most_like_line = 0;
  std::string_view line;
  while (lines.number() < last_heading_line && lines.next(line)) {
    if (is_passed_over(line)) continue;
    FoundHeading found{.separator = separator_of(line), .headings = {}, .positions = {}};
    found.headings = headings_in(lines, line, found.separator);
    std::string not_there;
    int count = 0;
    for (const WantedColumn& column : wanted) {
      const auto places = places_of(found.headings, column.heading);
      if (places.size() > 1) lines.refuse("the column stands twice", column.heading, line);
      found.positions.push_back(places.empty() ? no_position : places.front());
      count += places.empty() ? 0 : 1;
      if (places.empty() && !column.is_optional && not_there.empty()) not_there = column.heading;
    }
    if (not_there.empty()) return found;
    if (count > most_found) {
      most_found = count;
      most_like = found.headings;
      most_like_line = lines.number();
      missing = not_there;
    }
  }
  if (most_like_line == 0)
    throw Error(ExitCode::bad_input, "the file is empty; a heading is needed",
                {.file = lines.name(), .line = lines.number()});
  throw Error(ExitCode::bad_input, "the column is missing",
              {.file = lines.name(),
               .line = most_like_line,
               .key = missing,
               .value = listed(most_like),
               .allowed = fmt::format("a heading with {}", missing)});
}

bool is_row_of_units(const std::vector<std::string_view>& fields, std::size_t columns) {
  if (fields.size() != columns) return false;
  bool any = false;
  for (const std::string_view field : fields) {
    if (field.empty() || field == "-") continue;
    TableDialect plain{.separator = ';'};
    if (number_in(field, plain) || !find_unit(unit_of_row(field))) return false;
    any = true;
  }
  return any;
}

std::string unit_of_row(std::string_view field) {
  std::string_view text = trimmed(field);
  if (text.size() > 2 && ((text.starts_with('(') && text.ends_with(')')) ||
                          (text.starts_with('[') && text.ends_with(']'))))
    text = text.substr(1, text.size() - 2);
  return std::string(trimmed(text));
}

bool only_empty_beyond(const std::vector<std::string_view>& fields, std::size_t columns) {
  return fields.size() >= columns &&
         std::all_of(fields.begin() + static_cast<std::ptrdiff_t>(columns), fields.end(),
                     [](std::string_view field) { return field.empty(); });
}

double accepted_factor(const std::string& file, const WantedColumn& wanted, ReadColumn& column,
                       int heading_line) {
  if (wanted.accepted.empty()) return 1.0;
  const std::string& unit = column.heading.unit;
  const auto refuse = [&](const std::string& reason) {
    throw Error(ExitCode::bad_input, reason,
                {.file = file,
                 .line = heading_line,
                 .key = column.heading.text,
                 .value = unit,
                 .allowed = units_of(wanted.accepted)});
  };
  for (const Dimension& dimension : wanted.accepted) {
    const auto found = unit.empty() ? LaboratoryUnit{1.0, dimension::none}
                                    : find_unit(unit, dimension).value_or(LaboratoryUnit{0.0, {}});
    if (found.factor == 0.0) refuse("the unit of the column is not known");
    if (!same_dimension(found.dimension, dimension)) continue;
    column.dimension = dimension;
    return found.factor;
  }
  refuse(unit.empty() ? "the column states no unit" : "the column is in another unit");
  return 0.0;
}

}  // namespace rebound
