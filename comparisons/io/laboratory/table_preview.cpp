#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "comparisons/io/laboratory/array_table.hpp"
#include "comparisons/io/laboratory/laboratory_table.hpp"
#include "comparisons/io/laboratory/table_headings.hpp"
#include "comparisons/io/laboratory/text_lines.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// A line that may turn out to be the heading.
struct Candidate {
  std::string line;
  int number = 0;
  std::vector<std::string> units;  ///< of a row below it, if there is one
  std::size_t fields = 0;
};

bool any_number(const std::vector<std::string_view>& fields) {
  return std::any_of(fields.begin(), fields.end(), [](std::string_view field) {
    TableDialect either{.separator = ';'};
    return number_in(field, either).has_value();
  });
}

TablePreview preview_of(const Candidate& candidate) {
  TablePreview preview;
  preview.dialect.separator = separator_of(candidate.line);
  preview.heading_line = candidate.number;
  const auto fields = split_fields(candidate.line, preview.dialect.separator);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    ColumnHeading heading = parse_heading(fields[i]);
    if (heading.unit.empty() && !candidate.units.empty()) heading.unit = candidate.units[i];
    preview.headings.push_back(std::move(heading));
    preview.columns_at.push_back(static_cast<int>(fields[i].data() - candidate.line.data()) + 1);
  }
  preview.is_number.assign(fields.size(), true);
  return preview;
}

void look_at_row(const std::vector<std::string_view>& fields, TablePreview& preview) {
  ++preview.rows;
  for (std::size_t i = 0; i < std::min(fields.size(), preview.headings.size()); ++i)
    if (!number_in(fields[i], preview.dialect)) preview.is_number[i] = false;
}

}  // namespace

TablePreview preview_table(const std::filesystem::path& file) {
  if (is_array_file(file)) return preview_array_file(file);
  TextLines lines(file);
  std::optional<Candidate> candidate;
  std::optional<TablePreview> preview;
  std::string_view line;
  while (lines.next(line)) {
    if (is_passed_over(line)) continue;
    const char separator = preview     ? preview->dialect.separator
                           : candidate ? separator_of(candidate->line)
                                       : separator_of(line);
    const auto fields = split_fields(line, separator);
    if (preview) {
      look_at_row(fields, *preview);
      continue;
    }
    if (candidate && candidate->fields == fields.size() && any_number(fields)) {
      preview = preview_of(*candidate);
      look_at_row(fields, *preview);
    } else if (candidate && is_row_of_units(fields, candidate->fields)) {
      for (const std::string_view field : fields) candidate->units.push_back(unit_of_row(field));
    } else {
      const auto own = split_fields(line, separator_of(line));
      candidate.reset();
      if (own.size() > 1 && !any_number(own))
        candidate = Candidate{std::string(line), lines.number(), {}, own.size()};
    }
  }
  if (!preview)
    throw Error(ExitCode::bad_input,
                "no heading was found: a line of names, parted by commas, semicolons or "
                "tabulators, above rows of as many fields with numbers",
                {.file = file.string(), .line = lines.number()});
  return *preview;
}

}  // namespace rebound
