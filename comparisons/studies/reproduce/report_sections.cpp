#include "comparisons/studies/reproduce/report_sections.hpp"

#include <fmt/format.h>

#include "comparisons/studies/reproduce/figures.hpp"

namespace rebound {
namespace {

report::TableCell::Verdict mark_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::reproduces: return report::TableCell::Verdict::good;
    case Verdict::within_rounding: return report::TableCell::Verdict::none;
    case Verdict::differs: return report::TableCell::Verdict::bad;
  }
  return report::TableCell::Verdict::none;
}

report::Table row_table(const std::string& title, const std::vector<Row>& rows) {
  report::Table table;
  table.title = title;
  table.caption =
      "Rounding allows: the range of the computed number over all values of its inputs "
      "that would have been printed the same.";
  table.columns = {
      {"where"},
      {"of"},
      {"quantity"},
      {"published", "as named", report::TableColumn::Kind::number},
      {"computed", "as named", report::TableColumn::Kind::number, report::Origin::derived},
      {"rounding allows", "as named", report::TableColumn::Kind::number, report::Origin::derived},
      {"unit"},
      {"verdict"}};
  for (const Row& row : rows)
    table.rows.push_back(
        {report::text_cell(row.key.table), report::text_cell(scope_of(row.key.core, row.key.speed)),
         report::text_cell(row.key.quantity),
         report::text_cell(as_printed(row, row.published.value)),
         report::text_cell(as_printed(row, row.computed, 1)),
         report::text_cell(fmt::format("{} to {}", as_printed(row, row.range.low, 1),
                                       as_printed(row, row.range.high, 1))),
         report::text_cell(row.key.unit == "1" ? "–" : row.key.unit),
         report::text_cell(name_of(row.verdict), mark_of(row.verdict))});
  return table;
}

std::vector<Row> rows_with(const Reproduction& reproduction, bool differing) {
  std::vector<Row> rows;
  for (const Row& row : differences_first(reproduction.rows))
    if ((row.verdict == Verdict::differs) == differing) rows.push_back(row);
  return rows;
}

std::string counts(const Reproduction& reproduction) {
  return fmt::format(
      "Of {} published numbers that follow from others, {} reproduce to the digit, "
      "{} within rounding, and {} do not.",
      reproduction.rows.size(), reproduction.count(Verdict::reproduces),
      reproduction.count(Verdict::within_rounding), reproduction.count(Verdict::differs));
}

}  // namespace

std::vector<report::Section> report_sections(const Reproduction& reproduction) {
  report::Section findings{.title = "What the paper's numbers do not imply",
                           .folding = report::Section::Folding::open,
                           .blocks = {report::Paragraph{counts(reproduction)}}};
  for (const Finding& finding : reproduction.findings) {
    findings.blocks.push_back(
        report::Notice{report::Notice::Level::finding, finding.statement, finding.evidence});
  }
  report::Section differing{.title = "Published numbers that do not follow",
                            .folding = report::Section::Folding::folded,
                            .blocks = {row_table("Differing", rows_with(reproduction, true))}};
  report::Section following{.title = "Published numbers that follow",
                            .folding = report::Section::Folding::folded,
                            .blocks = {row_table("Following", rows_with(reproduction, false))}};
  report::Section figures{.title = "Figures 3 to 6, predicted from published parameters",
                          .folding = report::Section::Folding::folded,
                          .blocks = {contact_time_matrix(reproduction),
                                     published_impacts(reproduction), figure_5(reproduction)}};
  for (const report::Figure& figure : figure_6(reproduction)) figures.blocks.push_back(figure);
  return {findings, differing, following, figures};
}

report::Report reproduction_report(const Reproduction& reproduction) {
  report::Report report;
  report.title = "The sliotar paper's numbers, checked against each other";
  report.subtitle = "Hanley et al., Tables 2 to 5 and the numbers of the text";
  report.headline = counts(reproduction);
  report.sections = report_sections(reproduction);
  for (report::Section& section : report.sections) section.folding = report::Section::Folding::open;
  return report;
}

}  // namespace rebound
