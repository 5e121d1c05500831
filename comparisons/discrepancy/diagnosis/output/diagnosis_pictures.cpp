#include "comparisons/discrepancy/diagnosis/output/diagnosis_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/io/text.hpp"

namespace rebound {
namespace {

using report::Origin;
using report::Series;

/// What a curve depends on, as an axis says it.
report::Axis axis_of(const FactorBand& band) {
  if (band.of == "rate_m_s") return {"rate of deflection", "m/s"};
  return {with_blanks(band.of), "1"};
}

}  // namespace

report::Matrix map_matrix(const Diagnosis& d) {
  const ResidualMap& map = d.believed.map;
  report::Matrix matrix{
      .title = "Mean residual of each shot, by part of the contact",
      .caption =
          fmt::format("Mean residual of the believed model, refitted, over its spread when "
                      "nothing is missing: beyond ±{:.1f} the noise alone goes once in fifty "
                      "maps. Positive: the model is too high.",
                      map.threshold),
      .quantity = "mean whitened residual z",
      .unit = "1",
      .row_heading = "shot",
      .hatching = "within the noise",
      .scale = {report::ColourScale::Kind::diverging, std::max(10.0, map.threshold)},
      .overlays = {},
      .columns = {},
      .rows = {}};
  std::vector<std::pair<Phase, ObservedQuantity>> columns;
  for (const MapCell& cell : map.cells) {
    const std::pair key{cell.phase, cell.what};
    if (std::find(columns.begin(), columns.end(), key) == columns.end()) columns.push_back(key);
  }
  std::sort(columns.begin(), columns.end());
  for (const auto& [phase, what] : columns)
    matrix.columns.push_back({name_of(what), name_of(phase)});
  const std::size_t shots = d.seen->shots.size();
  for (std::size_t i = 0; i < shots + d.seen->compressions.size(); ++i) {
    report::MatrixRow row{
        i < shots ? d.seen->shots[i].label : d.seen->compressions[i - shots].label, {}};
    for (const auto& [phase, what] : columns) {
      report::MatrixCell cell{.value = {}, .text = "–"};
      for (const MapCell& c : map.cells)
        if (c.shot == i && c.phase == phase && c.what == what)
          cell = {.value = c.z,
                  .text = fmt::format("{:+.1f}", c.z),
                  .hatched = std::abs(c.z) <= map.threshold};
      row.cells.push_back(cell);
    }
    matrix.rows.push_back(row);
  }
  return matrix;
}

report::Matrix cosine_matrix(const Diagnosis& d) {
  const auto& cosines = d.selection.cosines;
  report::Matrix matrix{.title = "Which effects look alike in these data",
                        .caption =
                            "Cosine between what two effects do to the residuals, what the "
                            "fit can absorb taken out. ±1: cannot be told apart by any fit.",
                        .quantity = "cosine",
                        .unit = "1",
                        .row_heading = "effect",
                        .hatching = {},
                        .scale = {report::ColourScale::Kind::diverging, 1.0},
                        .overlays = {},
                        .columns = {},
                        .rows = {}};
  for (std::size_t i = 0; i < cosines.names.size(); ++i) {
    matrix.columns.push_back({"", cosines.names[i]});
    report::MatrixRow row{cosines.names[i], {}};
    for (std::size_t j = 0; j < cosines.names.size(); ++j) {
      const double value =
          cosines.cosine(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      row.cells.push_back({.value = value, .text = fmt::format("{:.2f}", value)});
    }
    matrix.rows.push_back(row);
  }
  return matrix;
}

report::Figure curve_figure(const FactorBand& band) {
  const bool factor = band.quantity == "factor";
  const std::string quantity = with_blanks(band.quantity);
  report::Figure figure{
      .title = "The missing " + quantity + " over the " + axis_of(band).quantity,
      .caption = factor ? "What the force of the believed model has to be multiplied by: 1 is "
                          "nothing missing. Where the law has a number of its own for the level, "
                          "the curve stands over its mean. The points are fitted, with their 95 % "
                          "band; the extended model goes smoothly through them."
                        : "The points are fitted, with their 95 % band; the extended model goes "
                          "smoothly through them.",
      .x = axis_of(band),
      .y = {quantity, "1"}};
  Series curve{.name = "fitted curve",
               .origin = Origin::fitted,
               .x = band.x,
               .y = band.factor,
               .y_low = band.low,
               .y_high = band.high};
  Series nothing{.name = "nothing missing",
                 .origin = Origin::predicted,
                 .role = Series::Role::reference,
                 .x = band.x,
                 .y = std::vector<double>(band.x.size(), factor ? 1.0 : 0.0)};
  figure.series = {std::move(nothing), std::move(curve)};
  return figure;
}

}  // namespace rebound
