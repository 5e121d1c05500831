#include "comparisons/verification/verification_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rebound {
namespace {

using report::Axis;
using report::Figure;
using report::Series;

report::Table ladder(const VerificationTable& table) {
  using Kind = report::TableColumn::Kind;
  report::Table shown{.title = "Verification ladder",
                      .caption = "Deviation and tolerance are relative, or absolute where the target "
                                 "is zero or a bound. The order is observed under refinement.",
                      .columns = {{"rung"},
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
    shown.rows.push_back(
        {report::text_cell(row.rung), report::text_cell(row.quantity),
         report::text_cell(row.unit.empty() ? "1" : row.unit), report::number_cell(row.target, 7),
         report::number_cell(row.result, 7), report::text_cell(fmt::format("{:.1e}", row.deviation())),
         report::text_cell(fmt::format("{:.1e}", row.tolerance)),
         row.order ? report::number_cell(*row.order, 3) : report::text_cell("–"),
         row.passes() ? report::text_cell("passes", Verdict::good)
                      : report::text_cell("fails", Verdict::bad),
         report::text_cell(row.source)});
  return shown;
}

Axis cells_axis() { return {"cells", "1", Axis::Spacing::logarithmic}; }

/// A line through `at` of the given power, over the cells of the family.
Series guide(const std::vector<FamilyImpact>& family, const std::string& name, double power,
             double at_last) {
  Series line{.name = name, .role = Series::Role::reference, .x = {}, .y = {}, .x_error = {},
              .y_error = {}, .y_low = {}, .y_high = {}};
  const double last = family.back().result.cells;
  for (const FamilyImpact& member : family) {
    line.x.push_back(member.result.cells);
    line.y.push_back(at_last * std::pow(member.result.cells / last, power));
  }
  return line;
}

template <class Value>
Series points(const std::vector<FamilyImpact>& family, const std::string& name, const Value& value) {
  Series series{.name = name, .style = Series::Style::points, .x = {}, .y = {}, .x_error = {},
                .y_error = {}, .y_low = {}, .y_high = {}};
  for (const FamilyImpact& member : family) {
    const double y = value(member);
    if (!(y > 0.0)) continue;
    series.x.push_back(member.result.cells);
    series.y.push_back(y);
  }
  return series;
}

Figure convergence(const std::vector<FamilyImpact>& family) {
  const FemResult& finest = family.back().result;
  const auto error_of = [&](double ImpactScalars::* scalar) {
    return [&, scalar](const FamilyImpact& member) {
      return std::abs(member.result.scalars.*scalar / (finest.scalars.*scalar) - 1.0);
    };
  };
  Figure figure{.title = "Convergence at 15 m/s",
                .caption = fmt::format("Deviation from {} cells. Second order in the cell size falls "
                                       "with the line.", finest.cells),
                .x = cells_axis(),
                .y = {"relative deviation", "1", Axis::Spacing::logarithmic},
                .series = {}};
  figure.series = {
      points(family, "restitution", error_of(&ImpactScalars::restitution)),
      points(family, "largest deflection", error_of(&ImpactScalars::peak_deflection)),
      points(family, "contact time above 1 %", error_of(&ImpactScalars::contact_time_1pct)),
      points(family, "largest force", error_of(&ImpactScalars::peak_force))};
  const double start = figure.series.front().y.empty() ? 1e-3 : figure.series.front().y.front();
  const double falls = start * family.front().result.cells / finest.cells;
  figure.series.push_back(guide(family, "second order", -1.0, falls));
  return figure;
}

Figure ripple(const std::vector<FamilyImpact>& family) {
  return {.title = "Ripple of the force at 15 m/s",
          .caption = "Largest deviation of the 20 µs mean from that on four times the cells, over 5 to "
                     "95 % of the contact. The line is the 0.5 % that is asked for at 4000 cells.",
          .x = cells_axis(),
          .y = {"deviation over peak force", "1", Axis::Spacing::logarithmic},
          .series = {points(family, "ripple",
                            [](const FamilyImpact& member) { return member.ripple.value_or(0.0); }),
                     guide(family, "asked for", 0.0, 5e-3)}};
}

Figure cost(const std::vector<FamilyImpact>& family) {
  const double last = family.back().result.wall_seconds;
  return {.title = "Cost of one impact",
          .caption = "Step loop alone, one thread, samples every microsecond; this machine, as busy "
                     "as it was. The line is cells to the power of 1.6.",
          .x = cells_axis(),
          .y = {"time", "s", Axis::Spacing::logarithmic},
          .series = {points(family, "step loop",
                            [](const FamilyImpact& member) { return member.result.wall_seconds; }),
                     guide(family, "cells^1.6", 1.6, last)}};
}

}  // namespace

report::Report verification_report(const VerificationTable& table,
                                   const std::vector<FamilyImpact>& family) {
  const auto passed = std::count_if(table.begin(), table.end(),
                                    [](const VerificationRow& row) { return row.passes(); });
  report::Report page;
  page.title = "Verification";
  page.headline = fmt::format("{} of {} known numbers come out within their tolerance.", passed,
                              table.size());
  if (!all_pass(table))
    page.notices.push_back({report::Notice::Level::failure, "Rows of the ladder fail; see the table."});
  if (!family.empty())
    page.sections.push_back({.title = "Finite elements under refinement",
                             .blocks = {convergence(family), ripple(family), cost(family)}});
  page.sections.push_back({.title = "Row by row", .blocks = {ladder(table)}});
  return page;
}

}  // namespace rebound
