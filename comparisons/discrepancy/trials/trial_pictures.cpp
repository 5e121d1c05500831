#include "comparisons/discrepancy/trials/trial_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/trials/trial_text.hpp"
#include "comparisons/io/text.hpp"

namespace rebound {
namespace {

using report::Origin;
using report::Series;

Series rate_series(const std::string& name, const RateTable& table, Share RateRow::*share) {
  Series series{.name = name, .origin = Origin::derived};
  for (const RateRow& row : table.rows) {
    const Share& one = row.*share;
    if (one.of == 0 || row.high <= 0.0) continue;
    constexpr double smallest_shown = 10.0;  // a logarithmic axis has no zero
    series.x.push_back(std::sqrt(std::max(row.low, smallest_shown) * row.high));
    series.y.push_back(one.percent());
    series.y_low.push_back(std::min(one.percent_low(), one.percent()));
    series.y_high.push_back(std::max(one.percent_high(), one.percent()));
  }
  return series;
}

}  // namespace

report::Matrix confusion_matrix(const ConfusionMatrix& confusion, const std::string& title,
                                const std::string& row_heading, const std::string& group) {
  report::Matrix matrix{.title = title,
                        .caption =
                            "Colour: share of the trials of a row. Number: how many they are. "
                            "Effects that do not show are left out.",
                        .quantity = "share of the row",
                        .unit = "1",
                        .row_heading = row_heading,
                        .hatching = {},
                        .scale = {report::ColourScale::Kind::sequential, 1.0},
                        .overlays = {},
                        .columns = {},
                        .rows = {}};
  const auto columns = columns_of(confusion);
  for (const std::string& column : columns) matrix.columns.push_back({group, column});
  for (const auto& [name, cells] : confusion) {
    int total = 0;
    for (const auto& [column, count] : cells) total += count;
    report::MatrixRow row{fmt::format("{} ({})", with_blanks(name), total), {}};
    for (const std::string& column : columns) {
      const auto found = cells.find(column);
      const int count = found == cells.end() ? 0 : found->second;
      row.cells.push_back({.value = static_cast<double>(count) / total,
                           .text = count == 0 ? "–" : fmt::format("{}", count)});
    }
    matrix.rows.push_back(std::move(row));
  }
  return matrix;
}

std::vector<report::Figure> power_figures(const RateTable& by_size) {
  const std::pair<const char*, Share RateRow::*> questions[] = {
      {"a gap is said", &RateRow::detected},
      {"the family is right", &RateRow::family_right},
      {"the name is right or in the set", &RateRow::name_right}};
  std::vector<report::Figure> figures;
  for (const auto& [words, share] : questions) {
    Series series = rate_series(words, by_size, share);
    if (series.x.empty()) continue;
    figures.push_back(
        {.title = fmt::format("Power: {}", words),
         .caption = "Single effects of a family, by how plainly they show. A point in the middle "
                    "of each bin of the table below; the band is its 95 % Wilson interval. Left of "
                    "25 an effect does not count.",
         .x = {"visible χ² of the hidden effect", "1", report::Axis::Spacing::logarithmic},
         .y = {"share of the trials", "%"},
         .series = {std::move(series)}});
  }
  return figures;
}

}  // namespace rebound
