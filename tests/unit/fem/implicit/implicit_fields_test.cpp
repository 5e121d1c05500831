// Fields of the second scheme, read back: against its energy balance and trace.
#include "fem/implicit/implicit_fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fem/implicit/implicit_impact.hpp"
#include "meshes/generate/sphere_mesh.hpp"
#include "tests/support/fem_cases.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/vtu.hpp"

namespace rebound::fem {
namespace {

/// One viscoelastic impact and the frames it wrote.
struct Shown {
  FemResult result, alone;
  std::vector<test::Vtu> frames;
};

const Shown& shown() {
  static const Shown known = [] {
    testing::TemporaryFolder folder;
    FemProblem problem = test::common_case(15);
    problem.material.branches = {{0.3, 0.3e-3, Relaxes::all}, {0.1, 3e-3, Relaxes::deviator}};
    const Mesh mesh = generate_sphere_mesh({.radius = 0.0331, .cells = 60});
    Shown made{.result = {}, .alone = run_implicit_impact(mesh, problem, {}), .frames = {}};
    problem.controls.field_frames = problem.controls.shape_frames = 20;
    problem.controls.field_directory = folder.path().string();
    made.result = run_implicit_impact(mesh, problem, {});
    for (const auto& [time, file] : test::read_pvd(folder.path() / "impact.pvd")) {
      made.frames.push_back(test::read_vtu(folder.path() / file));
      EXPECT_EQ(made.frames.back().time, time);
    }
    return made;
  }();
  return known;
}

/// ∫ p 2π r ds over the deformed underside: nodes of the outline's lower half by radius,
/// which pressure and radius are linear between.
double contact_force(const test::Vtu& frame) {
  const auto& x = frame.values("points_m");
  const auto& u = frame.values("displacement_m");
  const auto& p = frame.values("contact_pressure_Pa");
  const ShapeHistory& shapes = shown().result.shapes;
  double force = 0.0;
  for (std::size_t i = 2; i < shapes.contact_vertices.size(); i += 2) {  // ends of sides
    const int a = shapes.contact_vertices[i - 2], b = shapes.contact_vertices[i];
    const double ra = x[3 * a] + u[3 * a], rb = x[3 * b] + u[3 * b];
    const double za = x[3 * a + 1] + u[3 * a + 1], zb = x[3 * b + 1] + u[3 * b + 1];
    const double middle = 0.25 * (p[a] + p[b]) * (ra + rb);
    force += 2.0 * std::numbers::pi * std::hypot(rb - ra, zb - za) / 6.0 *
             (p[a] * ra + 4.0 * middle + p[b] * rb);
  }
  return force;
}

TEST(ImplicitFieldsTest, DensitiesSumUpToTheEnergyBalance) {
  const double brought = 0.5 * 0.0896 * 15.0 * 15.0;
  ASSERT_GE(shown().frames.size(), 15u);
  int compared = 0;
  for (const test::Vtu& frame : shown().frames)
    for (std::size_t k = 0; k < shown().result.trace.time.size(); ++k) {
      if (std::abs(shown().result.trace.time[k] - frame.time) > 1e-12) continue;
      const EnergyBalance& balance = shown().result.energies[k];
      EXPECT_NEAR(integral_over_cells(frame, "stored_energy_J_m3"), balance.stored, 1e-6 * brought);
      // Two sums over steps, by S:dE and by branches: apart to second order in the step.
      EXPECT_NEAR(integral_over_cells(frame, "dissipated_or_held_energy_J_m3"),
                  balance.held + balance.dissipated, 2e-4 * brought);
      ++compared;
    }
  EXPECT_GE(compared, 15);
}

TEST(ImplicitFieldsTest, PressureIntegratesToTheForceOfTheTrace) {
  const Trace& trace = shown().result.trace;
  const double peak = shown().result.scalars.peak_force, interval = trace.time[1];
  int compared = 0;
  for (const test::Vtu& frame : shown().frames) {
    // The window is a part of the last four samples: its mean lies between their extremes.
    const auto at = static_cast<std::size_t>(frame.time / interval + 0.5);
    if (at < 4 || at >= trace.force.size()) continue;
    const auto [least, most] =
        std::minmax_element(trace.force.begin() + at - 4, trace.force.begin() + at + 1);
    const double force = contact_force(frame);
    EXPECT_GE(force, *least - 1e-3 * peak) << frame.time;
    EXPECT_LE(force, *most + 1e-3 * peak) << frame.time;
    ++compared;
  }
  EXPECT_GE(compared, 12);
}

TEST(ImplicitFieldsTest, CellsAreBiquadraticAndEveryArrayIsThere) {
  for (const test::Vtu& frame : shown().frames) {
    EXPECT_EQ(frame.values("types")[0], 28.0);
    EXPECT_EQ(frame.values("connectivity").size(), 9 * frame.cells);
    EXPECT_EQ(frame.values("velocity_m_s").size(), 3 * frame.points);
    for (const char* name : {"cauchy_stress_rr_Pa", "von_mises_stress_Pa", "pressure_Pa"})
      for (const double value : frame.values(name)) ASSERT_TRUE(std::isfinite(value)) << name;
  }
  // The volume of the drawn cells is that of the ball.
  double volume = 0.0;
  for (const double v : shown().frames[0].values("volume_at_rest_m3")) volume += v;
  EXPECT_NEAR(volume / (4.0 / 3.0 * std::numbers::pi * std::pow(0.0331, 3)), 1.0, 1e-4);
}

TEST(ImplicitFieldsTest, WatchingChangesNoBitAndShapesComeInQuarters) {
  EXPECT_EQ(shown().alone.trace.force, shown().result.trace.force);
  EXPECT_EQ(shown().alone.closures.energy, shown().result.closures.energy);
  EXPECT_TRUE(shown().alone.shapes.time.empty());
  const ShapeHistory& shapes = shown().result.shapes;
  ASSERT_EQ(shapes.cells.size(), 4u * static_cast<std::size_t>(shown().result.cells));
  ASSERT_EQ(shapes.time.size(), shown().frames.size());
  for (std::size_t cell = 0; cell < shapes.cells.size(); ++cell) {
    double area = 0.0;  // counter-clockwise, none over another's place
    const auto& at = shapes.positions[0];
    for (int i = 0; i < 4; ++i) {
      const auto &a = at[shapes.cells[cell][i]], &b = at[shapes.cells[cell][(i + 1) % 4]];
      area += 0.5 * (a[0] * b[1] - b[0] * a[1]);
    }
    EXPECT_GT(area, 0.0);
    EXPECT_EQ(shapes.fields[0].values[5][cell], shapes.fields[0].values[5][cell / 4 * 4]);
  }
}

}  // namespace
}  // namespace rebound::fem
