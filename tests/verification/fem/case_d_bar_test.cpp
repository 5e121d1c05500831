// Case d′: a bar without lateral contraction hits the plate. A compression
// wave of constant stress runs to the free end and back:
//
//   σ = ρ c v = 7.68011 kPa,   t = 2L/c = 0.7680115 ms,   e = 1,   c = √(E/ρ)
//
// The stress of the discrete body is 0.02 % above σ whatever the mesh: strain
// is v/c = 0.08 %, and the material stiffens under compression. Restitution
// comes to 1 as the cell size to the power of about 0.7: the wave front, a
// jump, disperses into vibration over a few cells.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "tests/support/fem_impacts.hpp"
#include "tests/support/meshes.hpp"

namespace rebound {
namespace {

constexpr double bar_radius = 0.01, length = 0.05, density = 589.8416, youngs_modulus = 10e6;
constexpr double area = std::numbers::pi * bar_radius * bar_radius;

const FemResult& bar_impact(int cells_along) {
  static std::map<int, FemResult> known;
  if (!known.contains(cells_along)) {
    FemProblem problem;
    problem.sphere = {.mass = density * area * length, .diameter = 2 * bar_radius};
    problem.impact.speed = 0.1;
    problem.material = {.youngs_modulus = youngs_modulus, .poisson_ratio = 0.0};
    const auto body = fem::discretise(test::cylinder({.radius = bar_radius,
                                                      .length = length,
                                                      .cells_across = 2,
                                                      .cells_along = cells_along}),
                                      problem.sphere.mass);
    known[cells_along] = fem::run_explicit_impact(body, problem, {});
  }
  return known[cells_along];
}

TEST(VerificationCaseDBar, StressAndContactTime) {
  const double wave_speed = std::sqrt(youngs_modulus / density);
  const FemResult& result = bar_impact(400);
  EXPECT_EQ(result.incomplete_because, "");
  EXPECT_LE(result.closures.impulse, 1e-6);
  EXPECT_LE(result.closures.energy, 1e-3);
  EXPECT_NEAR(result.scalars.contact_time / (2 * length / wave_speed), 1.0, 3e-3);

  // Mean over the middle half of the pulse.
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < result.trace.time.size(); ++i) {
    const double share = result.trace.time[i] / result.scalars.contact_time;
    if (share < 0.25 || share > 0.75) continue;
    sum += result.trace.force[i];
    ++count;
  }
  EXPECT_NEAR(sum / count / area / (density * wave_speed * 0.1), 1.0, 4e-4);
}

TEST(VerificationCaseDBar, RestitutionComesToOne) {
  double missing_before = 0.0;
  for (const int cells : {50, 100, 200, 400}) {
    const double missing = 1.0 - bar_impact(cells).restitution_momentum;
    EXPECT_GT(missing, 0.0);
    if (missing_before > 0.0) {
      EXPECT_GT(missing_before / missing, 1.4) << cells;
    }
    missing_before = missing;
  }
  EXPECT_LT(missing_before, 4e-3);
}

TEST(VerificationCaseDBar, ConstraintWorkIsProportionalToTheCell) {
  for (const int cells : {50, 100, 200})
    EXPECT_NEAR(
        bar_impact(cells).contact_constraint_share / bar_impact(2 * cells).contact_constraint_share,
        2.0, 0.1);
}

}  // namespace
}  // namespace rebound
