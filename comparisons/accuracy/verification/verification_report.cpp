#include "comparisons/accuracy/verification/verification_report.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rebound {
namespace {

constexpr std::size_t long_table = 30;  ///< rows from which on a table stands folded

report::TableCell target_cell(const VerificationRow& row) {
  if (row.scale == ToleranceScale::upper_bound)
    return report::text_cell(fmt::format("≤ {:.7g}", row.target));
  return report::number_cell(row.target, 7);
}

report::Table suite_table(const VerificationTable& table) {
  using Kind = report::TableColumn::Kind;
  report::Table shown{.title = "Verification suite",
                      .caption =
                          "Deviation and tolerance are relative, or absolute where the target "
                          "is zero or a bound, and what exceeds it where the target is marked as a "
                          "largest value. The order is observed under refinement.",
                      .columns = {{"case"},
                                  {"quantity"},
                                  {"unit"},
                                  {"target", "1", Kind::number},
                                  {"result", "1", Kind::number},
                                  {"deviation", "1", Kind::number},
                                  {"tolerance", "1", Kind::number},
                                  {"order", "1", Kind::number},
                                  {"verdict"},
                                  {"source"}},
                      .rows = {}};
  using Verdict = report::TableCell::Verdict;
  for (const VerificationRow& row : table)
    shown.rows.push_back({report::text_cell(row.case_id), report::text_cell(row.quantity),
                          report::text_cell(row.unit.empty() ? "1" : row.unit), target_cell(row),
                          report::number_cell(row.result, 7),
                          report::text_cell(fmt::format("{:.1e}", row.deviation())),
                          report::text_cell(fmt::format("{:.1e}", row.tolerance)),
                          row.order ? report::number_cell(*row.order, 3) : report::text_cell("–"),
                          row.passes() ? report::text_cell("passes", Verdict::good)
                                       : report::text_cell("fails", Verdict::bad),
                          report::text_cell(row.source)});
  return shown;
}

}  // namespace

report::Report verification_report(const SuiteOutcome& suite) {
  const VerificationTable table = suite.rows();
  const auto passed = std::count_if(table.begin(), table.end(),
                                    [](const VerificationRow& row) { return row.passes(); });
  report::Report page;
  page.title = "Verification";
  page.headline =
      fmt::format("{} of {} known numbers come out within their tolerance.", passed, table.size());
  if (!all_pass(table))
    page.notices.push_back(
        {report::Notice::Level::failure, "Rows of the verification suite fail; see the table."});
  if (!suite.not_run.empty())
    page.notices.push_back(
        {report::Notice::Level::warning,
         fmt::format("Interrupted; not run: {}.", fmt::join(suite.not_run, ", "))});
  for (const SuiteOutcome::Complete& one : suite.complete) {
    if (one.part.figures.empty() && one.part.tables.empty()) continue;
    report::Section section{.title = one.name, .blocks = {}};
    for (const report::Figure& figure : one.part.figures) section.blocks.push_back(figure);
    for (const report::Table& table_of_part : one.part.tables)
      (table_of_part.rows.size() > long_table ? section.details : section.blocks)
          .push_back(table_of_part);
    page.sections.push_back(std::move(section));
  }
  page.sections.push_back({.title = "Row by row",
                           .folding = report::Section::Folding::folded,
                           .blocks = {suite_table(table)}});
  return page;
}

}  // namespace rebound
