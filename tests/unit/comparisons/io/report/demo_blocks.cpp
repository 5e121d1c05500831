#include "tests/unit/comparisons/io/report/demo_blocks.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace rebound::report_tests {

using namespace report;

Animation squeezed_disc() {
  constexpr int rings = 10, sectors = 24, frames = 16;
  constexpr double disc_radius = 33.0;
  Animation animation{.title = "A made-up half-section",
                      .caption = "TEST DATA: an affine squeeze.",
                      .origin = Origin::predicted,
                      .length_unit = "mm",
                      .time_unit = "ms",
                      .cells = {},
                      .frames = {}};
  for (int ring = 0; ring < rings; ++ring) {
    for (int sector = 0; sector < sectors; ++sector) {
      const int corner = ring * (sectors + 1) + sector;
      animation.cells.push_back({corner, corner + sectors + 1, corner + sectors + 2, corner + 1});
    }
  }
  for (int i = 0; i <= frames; ++i) {
    const double squeeze = 0.25 * std::sin(std::numbers::pi * i / frames);
    AnimationFrame frame{.time = 2.0 * i / frames, .radius = {}, .height = {}};
    for (int ring = 0; ring <= rings; ++ring) {
      for (int sector = 0; sector <= sectors; ++sector) {
        const double angle = std::numbers::pi * sector / sectors;
        const double distance = disc_radius * ring / rings;
        frame.radius.push_back(distance * std::sin(angle) * (1.0 + 0.5 * squeeze));
        frame.height.push_back((disc_radius - distance * std::cos(angle)) * (1.0 - squeeze));
      }
    }
    animation.frames.push_back(frame);
  }
  // A field that grows with the squeeze and outward, one that does not move, a pressure.
  AnimationField stress{
      .name = "made-up stress", .unit = "MPa", .low = 0.0, .high = 2.0, .values = {}};
  AnimationField depth{
      .name = "made-up depth", .unit = "mm", .low = -1.0, .high = 1.0, .values = {}};
  animation.contact = {
      .vertices = {0, sectors + 2, 2 * sectors + 3}, .unit = "MPa", .pressure = {}};
  for (int i = 0; i <= frames; ++i) {
    const double squeeze = std::sin(std::numbers::pi * i / frames);
    std::vector<float> grown, still;
    for (int cell = 0; cell < rings * sectors; ++cell) {
      grown.push_back(static_cast<float>(2.0 * squeeze * (cell / sectors + 1) / rings));
      still.push_back(static_cast<float>(2.0 * (cell % sectors) / sectors - 1.0));
    }
    stress.values.push_back(std::move(grown));
    depth.values.push_back(std::move(still));
    animation.contact.pressure.push_back({3.0 * squeeze, 2.0 * squeeze, 0.0});
  }
  animation.fields = {std::move(stress), std::move(depth)};
  return animation;
}

Table checks_table() {
  using Verdict = TableCell::Verdict;
  Table table{
      .title = "Checks that were not fitted", .caption = "TEST DATA.", .columns = {}, .rows = {}};
  table.columns = {{"quantity"},
                   {"reading", "mm", TableColumn::Kind::number, Origin::measured},
                   {"model", "mm", TableColumn::Kind::number, Origin::predicted},
                   {"verdict"}};
  table.rows = {{text_cell("peak deflection"), uncertain_cell(5.21, 0.31), number_cell(5.0, 3),
                 text_cell("within the bar", Verdict::good)},
                {text_cell("mean deflection"), uncertain_cell(3.9, 0.2), number_cell(3.1, 3),
                 text_cell("20 % low", Verdict::bad)},
                {text_cell("residual deflection"), uncertain_cell(0.4, 0.4),
                 number_cell(-1.2e-7, 2), text_cell("the bar includes zero", Verdict::doubtful)}};
  return table;
}

Table wide_table() {
  Table table{
      .title = "A wide table", .caption = "TEST DATA.", .columns = {{"quantity"}}, .rows = {}};
  std::vector<TableCell> row{text_cell("reading")};
  for (int i = 1; i <= 14; ++i) {
    table.columns.push_back(
        {fmt::format("run {}", i), "kN", TableColumn::Kind::number, Origin::derived});
    row.push_back(number_cell(1.0 + 0.01 * i, 4));
    row.back().verdict = i % 2 == 0 ? TableCell::Verdict::good : TableCell::Verdict::bad;
  }
  table.rows = {row};
  return table;
}

Table linked_table() {
  Table table{.title = "Pages", .caption = "", .columns = {{"page"}}, .rows = {}};
  TableCell cell = text_cell("one");
  cell.link = "pages/one.html";
  table.rows = {{cell}};
  return table;
}

}  // namespace rebound::report_tests
