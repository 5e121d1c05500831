#include "comparisons/accuracy/verification/coverage_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "comparisons/accuracy/numerical_error/coverage.hpp"

namespace rebound {
namespace {

constexpr std::array quantities = {"restitution", "kinetic_energy_loss_share", "peak_deflection_m",
                                   "peak_force_N", "contact_time_tail_s"};

/// Share of the bars whose error over bar lies in each eighth of a decade.
report::Series histogram(const std::vector<JudgedBar>& judged, const std::string& name) {
  constexpr double lowest = -3.0, highest = 1.0;
  constexpr int classes = 32;
  report::Series series{.name = name};
  std::array<double, classes> count{};
  for (const JudgedBar& one : judged) {
    const double place = (std::log10(one.error / one.bar) - lowest) / (highest - lowest);
    count[static_cast<std::size_t>(std::clamp(place, 0.0, 1.0 - 1e-9) * classes)] += 1.0;
  }
  for (int i = 0; i < classes; ++i) {
    series.x.push_back(std::pow(10.0, lowest + (highest - lowest) * (i + 0.5) / classes));
    series.y.push_back(100.0 * count[i] / static_cast<double>(judged.size()));
  }
  return series;
}

/// Above this Poisson ratio cells have a mean dilatation, and their bars are shown by themselves.
constexpr double nearly_incompressible = 0.45;

std::vector<JudgedBar> of_rubber(std::vector<JudgedBar> judged) {
  std::erase_if(judged, [](const JudgedBar& one) {
    return one.row->point.poisson_ratio <= nearly_incompressible;
  });
  return judged;
}

void add_line(report::Table& table, const std::string& name, const std::vector<JudgedBar>& judged) {
  const Coverage found = coverage_of(judged);
  std::vector<double> shares;
  shares.reserve(judged.size());
  for (const JudgedBar& one : judged) shares.push_back(one.truth_error / one.bar);
  std::sort(shares.begin(), shares.end());
  table.rows.push_back({report::text_cell(name), report::number_cell(found.bars, 4),
                        report::number_cell(100.0 * found.share, 3),
                        report::number_cell(found.median_ratio, 3),
                        report::number_cell(shares.empty() ? 0.0 : shares[shares.size() / 2], 2),
                        report::number_cell(found.undecided, 3)});
}

report::Table table_of(const std::vector<CoverageRow>& rows) {
  using Kind = report::TableColumn::Kind;
  report::Table table{
      .title = "Coverage by quantity",
      .caption =
          "Bars that cover, and the median of bar over error; errors against fine families "
          "of the same cells, whose own error is the last column but one's share of the "
          "bar. The last: bars narrower than the truth is known to, which a better truth "
          "might judge otherwise; they count as they are.",
      .columns = {{"quantity"},
                  {"bars", "1", Kind::number},
                  {"cover", "%", Kind::number},
                  {"median bar over error", "1", Kind::number},
                  {"median error of the truth over bar", "1", Kind::number},
                  {"narrower than the truth is known", "1", Kind::number}},
      .rows = {}};
  for (const char* quantity : quantities) add_line(table, quantity, judge_bars(rows, quantity));
  for (const char* quantity : quantities)
    add_line(table, fmt::format("{}, Poisson ratio above {:g}", quantity, nearly_incompressible),
             of_rubber(judge_bars(rows, quantity)));
  return table;
}

void add_rows(const Coverage& found, const std::string& of, const std::string& source,
              VerificationTable& rows) {
  rows.push_back({.case_id = "error bars",
                  .quantity = fmt::format("share of the bars{} that cover the truth", of),
                  .unit = "",
                  .target = 0.95,
                  .result = found.share,
                  .tolerance = 0.03,
                  .scale = ToleranceScale::absolute,
                  .source = source});
  rows.push_back({.case_id = "error bars",
                  .quantity = fmt::format("median of bar over error{}", of),
                  .unit = "",
                  .target = 4.0,
                  .result = found.median_ratio,
                  .tolerance = 0.0,
                  .scale = ToleranceScale::upper_bound,
                  .source = source});
}

/// Root mean square of what both truths differ by, over the sum of their errors.
double difference_of_truths(const std::vector<CoverageRow>& rows) {
  std::map<std::pair<int, std::string>, CoverageTruth> bilinear;
  for (const CoverageRow& row : rows)
    if (row.use == FamilyUse::truth) bilinear[{row.number, row.quantity}] = truth_of(row);
  double square = 0.0;
  int count = 0;
  for (const CoverageRow& row : rows) {
    const auto found = bilinear.find({row.number, row.quantity});
    if (row.use != FamilyUse::nine_node || found == bilinear.end()) continue;
    const CoverageTruth nine = truth_of(row), four = found->second;
    square += std::pow((nine.value - four.value) / (nine.error + four.error), 2);
    ++count;
  }
  return std::sqrt(square / count);
}

}  // namespace

VerificationPart verify_coverage(const std::filesystem::path& table) {
  const std::vector<CoverageRow> rows = read_coverage(table);
  const auto judged = judge_bars(rows);
  const Coverage all = coverage_of(judged);
  std::set<std::pair<int, int>> cases;
  for (const JudgedBar& one : judged) cases.insert({one.row->number, one.row->cells});
  const std::string source = fmt::format(
      "stored campaign of {} families, five scalars each, "
      "not run now",
      cases.size());
  VerificationPart part;
  add_rows(all, "", source, part.rows);
  for (const char* quantity : quantities)
    add_rows(coverage_of(judge_bars(rows, quantity)), fmt::format(" of {}", quantity), source,
             part.rows);
  part.rows.push_back({.case_id = "error bars",
                       .quantity = "difference of bilinear and nine-node truth over their errors",
                       .unit = "",
                       .target = 1.0,
                       .result = difference_of_truths(rows),
                       .tolerance = 0.0,
                       .scale = ToleranceScale::upper_bound,
                       .source = source});
  report::Figure figure{
      .title = "How far the truth is, in bars",
      .caption = "Bars of every family of the stored campaign; right of 1 they do not cover.",
      .x = {"error over bar", "1", report::Axis::Spacing::logarithmic},
      .y = {"share of the bars", "%"}};
  figure.series.push_back(histogram(judged, "all quantities"));
  for (const char* quantity : quantities)
    figure.series.push_back(histogram(judge_bars(rows, quantity), quantity));
  part.figures.push_back(std::move(figure));
  part.tables.push_back(table_of(rows));
  return part;
}

}  // namespace rebound
