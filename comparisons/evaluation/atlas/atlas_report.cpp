#include <fmt/format.h>

#include <array>

#include "comparisons/evaluation/atlas/atlas_text.hpp"

namespace rebound {
namespace {

using report::ColourScale;
using report::Matrix;
using report::MatrixCell;

std::string percent(double value) {
  return fmt::format("{:.1f}", 100.0 * value);
}

/// Law by (calibrated at, used at): the spread over all materials.
Matrix spread_matrix(const Atlas& atlas, const AtlasQuantity& quantity, double limit) {
  Matrix matrix{.title = quantity.name,
                .caption =
                    "Median over all materials, in per cent; calibrated at the speed over the "
                    "group, used at the one below, both over the wave speed.",
                .quantity = "error of " + quantity.name,
                .unit = "%",
                .row_heading = "law",
                .hatching = {},
                .scale = {ColourScale::Kind::sequential, limit},
                .overlays = {},
                .columns = {},
                .rows = {}};
  const auto& speeds = atlas.grid.speeds;
  const std::array<std::size_t, 3> from = {0, speeds.size() / 2, speeds.size() - 1};
  for (std::size_t f : from)
    for (double to : speeds)
      matrix.columns.push_back(
          {fmt::format("calibrated at {:g}", speeds[f]), fmt::format("{:g}", to)});
  for (std::size_t law = 0; law < atlas_laws().size(); ++law) {
    auto& row = matrix.rows.emplace_back();
    row.name = atlas_laws()[law].label;
    for (std::size_t f : from)
      for (std::size_t to = 0; to < speeds.size(); ++to) {
        const AtlasSpread s = spread_of(atlas, quantity, law, f, to);
        MatrixCell cell;
        cell.text = s.cells == 0 ? "none" : percent(s.median);
        if (s.cells > 0) cell.value = 100.0 * s.median;
        row.cells.push_back(cell);
      }
  }
  return matrix;
}

/// Which law for which material, and the error to expect: loss factor and
/// relaxation time down, speed of use across.
Matrix advice_matrix(const Atlas& atlas, double poisson_ratio) {
  const std::size_t from = atlas.grid.speeds.size() / 2;
  Matrix matrix{
      .title = fmt::format("Which law, Poisson ratio {:g}", poisson_ratio),
      .caption = fmt::format("The law of least error in force over time when calibrated at "
                             "v/c = {:g}, and that error in per cent of the peak force.",
                             atlas.grid.speeds[from]),
      .quantity = "error of the best law, force over time",
      .unit = "%",
      .row_heading = "loss factor, relaxation time over contact time",
      .hatching = {},
      .scale = {ColourScale::Kind::sequential, 15.0},
      .overlays = {},
      .columns = {},
      .rows = {}};
  for (double speed : atlas.grid.speeds)
    matrix.columns.push_back({"used at v/c", fmt::format("{:g}", speed)});
  for (const auto& entry : atlas.entries) {
    if (entry.material.poisson_ratio != poisson_ratio) continue;
    auto& row = matrix.rows.emplace_back();
    row.name =
        fmt::format("{:g}, {:g}", entry.material.loss_factor, entry.material.relaxation_time);
    for (std::size_t to = 0; to < atlas.grid.speeds.size(); ++to) {
      const AtlasAdvice advice = advice_of(entry, from, to);
      MatrixCell cell;
      if (advice.law >= 0) {
        cell.value = 100.0 * advice.force_rms;
        cell.text = fmt::format("{} {}", atlas_laws()[static_cast<std::size_t>(advice.law)].label,
                                percent(advice.force_rms));
      } else {
        cell.text = "none";
      }
      row.cells.push_back(cell);
    }
  }
  return matrix;
}

}  // namespace

report::Report atlas_report(const Atlas& atlas) {
  report::Report page;
  page.title = "Law atlas";
  page.subtitle = fmt::format("{} FE impacts, {} laws",
                              atlas.entries.size() * atlas.grid.speeds.size(), atlas_laws().size());
  page.headline =
      "Where each contact law holds, calibrated at one speed and used at others, against "
      "finite elements.";
  report::Section maps{.title = "Use this law here, expect this error",
                       .folding = report::Section::Folding::open,
                       .blocks = {}};
  for (double nu : atlas.grid.poisson_ratios) maps.blocks.emplace_back(advice_matrix(atlas, nu));
  report::Section laws{
      .title = "Law by law", .folding = report::Section::Folding::open, .blocks = {}};
  for (const auto& quantity : atlas_quantities())
    laws.blocks.emplace_back(spread_matrix(atlas, quantity, 25.0));
  page.sections = {maps, laws};
  int failed = 0;
  for (const auto& entry : atlas.entries)
    for (const auto& impact : entry.impacts) failed += !impact.failure.empty();
  if (failed > 0)
    page.notices.push_back(
        {report::Notice::Level::warning,
         fmt::format("{} FE impacts did not end; their cells are empty", failed)});
  return page;
}

}  // namespace rebound
