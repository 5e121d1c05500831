#include "comparisons/accuracy/numerical_error/coverage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr const char* heading =
    "point,speed_over_wave_speed,poisson_ratio,branch_share,branch_time,use,cells,quantity,"
    "coarse,middle,fine,halved,scatter,ripple";

constexpr const char* uses[] = {"bars", "truth", "nine-node"};

CoverageRow parse(const std::string& line) {
  std::istringstream text(line);
  CoverageRow row;
  std::string use;
  char comma = 0;
  text >> row.number >> comma >> row.point.speed >> comma >> row.point.poisson_ratio >> comma >>
      row.point.branch_share >> comma >> row.point.branch_time >> comma;
  std::getline(text, use, ',');
  text >> row.cells >> comma;
  std::getline(text, row.quantity, ',');
  FamilyValues& values = row.values;
  text >> values.coarse >> comma >> values.middle >> comma >> values.fine >> comma >>
      values.halved >> comma >> values.scatter >> comma >> values.ripple;
  const auto* const found = std::find(std::begin(uses), std::end(uses), use);
  if (!text || found == std::end(uses))
    throw Error(ExitCode::corrupt_store, "a broken line in the table of bars: " + line);
  row.use = static_cast<FamilyUse>(found - std::begin(uses));
  return row;
}

}  // namespace

std::string coverage_heading() {
  return heading;
}

std::string to_csv(const CoverageRow& row) {
  const FamilyValues& values = row.values;
  return fmt::format(
      "{},{:.6g},{:.6g},{:.6g},{:.6g},{},{},{},{:.9g},{:.9g},{:.9g},{:.9g},{:.4g},"
      "{:.4g}\n",
      row.number, row.point.speed, row.point.poisson_ratio, row.point.branch_share,
      row.point.branch_time, uses[static_cast<int>(row.use)], row.cells, row.quantity,
      values.coarse, values.middle, values.fine, values.halved, values.scatter, values.ripple);
}

std::vector<CoverageRow> read_coverage(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw Error(ExitCode::input_output_failed, "cannot be read", {.file = file.string()});
  std::vector<CoverageRow> rows;
  bool headed = false;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    if (!headed && line != heading)
      throw Error(ExitCode::corrupt_store, "not a table of bars", {.file = file.string()});
    if (headed) rows.push_back(parse(line));
    headed = true;
  }
  return rows;
}

CoverageTruth truth_of(const CoverageRow& row) {
  constexpr double lowest = 1.0, highest = 2.0, of_contact = 1.5, largest_observed = 2.5;
  const FamilyValues& values = row.values;
  const double cells = values.fine - values.middle;
  if (row.use == FamilyUse::truth) {
    const double observed = std::log2((values.middle - values.coarse) / cells);
    const bool believed = observed >= lowest && observed <= largest_observed;
    const double order = believed ? std::min(observed, highest) : of_contact;
    return {.value = values.fine + cells / (std::exp2(order) - 1.0),
            .error = 0.5 * std::abs(cells)};
  }
  const double step = 4.0 / 3.0 * (values.halved - values.middle);
  return {.value = values.fine + step, .error = std::abs(cells) / 3.0 + 0.25 * std::abs(step)};
}

std::vector<JudgedBar> judge_bars(const std::vector<CoverageRow>& rows,
                                  const std::string& quantity) {
  std::map<std::pair<int, std::string>, CoverageTruth> truths;
  for (const CoverageRow& row : rows)
    if (row.use == FamilyUse::truth) truths[{row.number, row.quantity}] = truth_of(row);
  std::vector<JudgedBar> judged;
  for (const CoverageRow& row : rows) {
    if (row.use != FamilyUse::bars || (!quantity.empty() && row.quantity != quantity)) continue;
    const auto found = truths.find({row.number, row.quantity});
    if (found == truths.end()) continue;
    const CoverageTruth& truth = found->second;
    judged.push_back({.row = &row,
                      .truth = truth.value,
                      .truth_error = truth.error,
                      .error = std::abs(row.values.fine - truth.value),
                      .bar = scalar_error(row.quantity.c_str(), row.values).uncertainty});
  }
  return judged;
}

Coverage coverage_of(const std::vector<JudgedBar>& judged) {
  Coverage coverage{.bars = static_cast<int>(judged.size())};
  if (judged.empty()) return coverage;
  std::vector<double> ratios;
  ratios.reserve(judged.size());
  for (const JudgedBar& one : judged) ratios.push_back(one.bar / one.error);
  coverage.share =
      static_cast<double>(std::count_if(judged.begin(), judged.end(),
                                        [](const JudgedBar& one) { return one.covers(); })) /
      static_cast<double>(judged.size());
  coverage.undecided = static_cast<int>(std::count_if(
      judged.begin(), judged.end(), [](const JudgedBar& one) { return !one.decided(); }));
  const auto half = ratios.begin() + static_cast<long>(ratios.size() / 2);
  std::nth_element(ratios.begin(), half, ratios.end());
  coverage.median_ratio = *half;
  return coverage;
}

}  // namespace rebound
