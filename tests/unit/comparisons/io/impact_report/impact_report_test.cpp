#include "comparisons/io/impact_report/impact_report.hpp"

#include <gtest/gtest.h>

#include <variant>

#include "comparisons/accuracy/numerical_error/error_bars.hpp"
#include "comparisons/io/report/check.hpp"
#include "comparisons/io/report/json.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

FemProblem some_problem() {
  FemProblem problem;
  problem.sphere = {.mass = 0.0896, .diameter = 0.0662};
  problem.impact.speed = 15.0;
  return problem;
}

FemResult some_result() {
  FemResult result;
  result.trace.time = {0.0, 1e-3, 2e-3};
  result.trace.force = {0.0, 2000.0, 0.0};
  result.trace.deflection = {0.0, 5e-3, 1e-3};
  result.trace.further = {{"pole_deflection_m", {0.0, 6e-3, 1e-3}}};
  result.scalars = {.restitution = 0.75,
                    .contact_time = 2e-3,
                    .contact_time_1pct = 1.9e-3,
                    .peak_force = 2000.0,
                    .peak_deflection = 5e-3,
                    .mean_deflection = 2e-3,
                    .rebound_speed = 11.25};
  result.energies.resize(3);
  result.energies[1].stored = 8.0;
  result.cells = 1;
  return result;
}

template <class Kind>
std::vector<Kind> all(const report::Report& page) {
  std::vector<Kind> found;
  for (const auto& section : page.sections)
    for (const auto& block : section.blocks)
      if (const auto* match = std::get_if<Kind>(&block)) found.push_back(*match);
  return found;
}

TEST(ImpactReportTest, ShowsForceAndOnlyTheEnergiesThatActed) {
  const report::Report page = impact_report(some_problem(), some_result());
  EXPECT_NO_THROW(report::check_report(page));
  const auto figures = all<report::Figure>(page);
  ASSERT_EQ(figures.size(), 3u);
  EXPECT_EQ(figures[0].series[0].x, (std::vector<double>{0.0, 1.0, 2.0}));
  EXPECT_EQ(figures[0].series[0].y, (std::vector<double>{0.0, 2000.0, 0.0}));
  EXPECT_TRUE(figures[0].series[0].y_low.empty());
  EXPECT_EQ(figures[1].series[1].x, (std::vector<double>{0.0, 6.0, 1.0}));
  ASSERT_EQ(figures[2].series.size(), 1u);
  EXPECT_EQ(figures[2].series[0].name, "stored by the elastic law");
  EXPECT_NE(page.headline.find("0.750"), std::string::npos);
  EXPECT_TRUE(all<report::Animation>(page).empty());
}

TEST(ImpactReportTest, EveryChannelOfTheEnergyHasALineOfItsOwn) {
  FemResult result = some_result();
  result.energies[1] = {.kinetic_centre_of_mass = 1,
                        .kinetic_vibration = 2,
                        .stored = 3,
                        .held = 4,
                        .dissipated = 12,
                        .contact_constraint = 5,
                        .friction = 6,
                        .adhesion = 7,
                        .plate_kinetic = 8,
                        .plate_spring = 9,
                        .plate_damper = 10,
                        .gravity = 11};
  const report::Report page = impact_report(some_problem(), result);
  EXPECT_NO_THROW(report::check_report(page));
  const auto lines = all<report::Figure>(page)[2].series;
  ASSERT_EQ(lines.size(), 12u);
  double sum = 0.0;
  for (const auto& line : lines) sum += line.y[1];
  EXPECT_EQ(sum, 78.0);
}

TEST(ImpactReportTest, DrawsErrorBarsAsABandAndTheLoadCellBesideTheContact) {
  FemResult result = some_result();
  result.trace.further.push_back({"force_uncertainty_N", {1.0, 20.0, 1.0}});
  result.trace.further.push_back({"contact_force_N", {0.0, 2100.0, 0.0}});
  const auto figure = all<report::Figure>(impact_report(some_problem(), result))[0];
  EXPECT_EQ(figure.series[0].y_low, (std::vector<double>{-1.0, 1980.0, -1.0}));
  EXPECT_EQ(figure.series[0].y_high, (std::vector<double>{1.0, 2020.0, 1.0}));
  ASSERT_EQ(figure.series.size(), 2u);
  EXPECT_EQ(figure.series[1].y[1], 2100.0);
}

TEST(ImpactReportTest, SaysWhetherItIsAReference) {
  ReferenceImpact reference{.result = some_result(), .family = {{.cells = 60}}, .contact_nodes = 9};
  for (const ScalarOfResult& scalar : scalars_with_error())
    reference.errors.push_back({.key = scalar.key,
                                .uncertainty = 0.002 * scalar.value(reference.result),
                                .meshes = {.observed_order = 1.87}});
  report::Report page = impact_report(some_problem(), reference.result);
  page.sections.push_back(error_bars(reference));
  EXPECT_NO_THROW(report::check_report(page));
  const auto words = [&] {
    return all<report::Paragraph>({.sections = {error_bars(reference)}})[0].text;
  };
  EXPECT_TRUE(words().starts_with("A reference")) << words();
  const report::Table table = all<report::Table>({.sections = {error_bars(reference)}})[0];
  ASSERT_EQ(table.rows.size(), scalars_with_error().size());
  EXPECT_EQ(table.rows[0][3].text, "0.2");
  EXPECT_EQ(table.rows[0][8].text, "1.87");
  reference.errors[0].uncertainty = 0.006 * reference.result.scalars.restitution;
  EXPECT_NE(words().find("Not a reference: restitution not known"), std::string::npos) << words();
}

TEST(ImpactReportTest, ShapesMove) {
  FemResult result = some_result();
  result.shapes = {.cells = {{0, 1, 2, 3}},
                   .time = {0.0, 1e-3},
                   .positions = {2, {{0, 0}, {0.01, 0}, {0.01, 0.02}, {0, 0.02}}},
                   .fields = {{ShapeQuantity::stored, {{0.0f}, {5e3f}}}},
                   .contact_vertices = {0, 1},
                   .contact_pressure = {{0.0f, 0.0f}, {1e6f, 0.0f}}};
  const report::Report page = impact_report(some_problem(), result);
  EXPECT_NO_THROW(report::check_report(page));
  const auto moving = all<report::Animation>(page);
  ASSERT_EQ(moving.size(), 1u);
  EXPECT_EQ(moving[0].fields[0].unit, "kJ/m³");
  EXPECT_EQ(moving[0].fields[0].high, 5.0);
}

TEST(ImpactReportTest, RefusesAnIncompleteImpact) {
  FemResult result = some_result();
  result.incomplete_because = "interrupted";
  EXPECT_THROW(impact_report(some_problem(), result), Error);
}

TEST(ImpactReportTest, FineMeshesGetFewerFrames) {
  EXPECT_EQ(animated_frames(0, 1000), 0);
  EXPECT_EQ(animated_frames(20, 1000), 20);
  EXPECT_EQ(animated_frames(1000, 1000), 60);
  EXPECT_EQ(animated_frames(1000, 10000), 15);
  EXPECT_EQ(animated_frames(1000, 20001), 0);
}

/// Sixty frames of a thousand cells with six fields, positions of as many digits as there are.
TEST(ImpactReportTest, AThousandCellsForSixtyFramesStayBelowTwoMegabytes) {
  FemResult result = some_result();
  ShapeHistory& shapes = result.shapes;
  constexpr int side = 32;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const int corner = i * (side + 1) + j;
      shapes.cells.push_back({corner, corner + 1, corner + side + 2, corner + side + 1});
    }
  for (int k = 0; k < 6; ++k) shapes.fields.push_back({ShapeQuantity::stored, {}});
  for (int frame = 0; frame < 60; ++frame) {
    shapes.time.push_back(3.3e-5 * frame);
    auto& positions = shapes.positions.emplace_back();
    for (int vertex = 0; vertex < (side + 1) * (side + 1); ++vertex)
      positions.push_back({1.2345678e-3 * (vertex % 41), 3.4567e-5 * vertex + 1e-6 * frame});
    for (auto& field : shapes.fields)
      field.values.emplace_back(shapes.cells.size(), static_cast<float>(frame));
  }
  const std::string text = report::report_json(impact_report(some_problem(), result)).dump();
  EXPECT_LT(text.size(), 2'000'000u);
}

}  // namespace
}  // namespace rebound
