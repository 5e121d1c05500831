// Friction, and a plate that moves, by nine-node cells: against closed forms, against the
// explicit scheme, and with energy balances that close.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "fem/explicit/explicit_impact.hpp"
#include "fem/implicit/implicit_impact.hpp"
#include "fem/implicit/static_compression.hpp"
#include "meshes/generate/sphere_mesh.hpp"
#include "tests/support/fem_cases.hpp"

namespace rebound::fem {
namespace {

Mesh sphere(int cells) {
  return generate_sphere_mesh({.radius = 0.0331, .cells = cells});
}

FemResult complete(FemResult result) {
  EXPECT_EQ(result.incomplete_because, "");
  EXPECT_LT(result.closures.impulse, 1e-6);
  EXPECT_LT(result.closures.energy, 1e-3);
  EXPECT_NEAR(result.scalars.restitution, result.restitution_momentum, 1e-6);
  return result;
}

FemResult implicit_on(const FemProblem& problem, int cells) {
  return complete(run_implicit_impact(sphere(cells), problem, {}));
}

FemResult explicit_on(const FemProblem& problem, int cells) {
  return complete(run_explicit_impact(discretise(sphere(cells), problem.sphere.mass), problem, {}));
}

FemProblem rubbing(double friction) {
  FemProblem problem = test::common_case(15);
  problem.plate.friction = friction;
  return problem;
}

std::array<double, 3> compared(const FemResult& result) {
  return {result.energies.back().friction, result.restitution_momentum,
          result.scalars.peak_deflection};
}

// A bar is what a half (nine nodes) or a quarter of the cells changes. Friction of nine-node cells
// converges in the first order, from above: with 60, 120 and 240 cells 0.035, 0.027, 0.022 J.
TEST(ImplicitContact, FrictionTakesWhatItTakesInTheOtherScheme) {
  const FemProblem problem = rubbing(0.2);
  const auto coarse = compared(implicit_on(problem, 60)),
             second = compared(implicit_on(problem, 120));
  const auto few = compared(explicit_on(problem, 500)),
             first = compared(explicit_on(problem, 2000));
  EXPECT_GT(first[0], 0.01);
  for (std::size_t i = 0; i < first.size(); ++i)
    EXPECT_LE(std::abs(second[i] - first[i]), std::hypot(second[i] - coarse[i], first[i] - few[i]))
        << i;
}

// What sliding takes grows with a small coefficient, and no friction is lost in sticking.
TEST(ImplicitContact, FrictionNeverDrives) {
  const FemResult little = implicit_on(rubbing(0.02), 60), stuck = implicit_on(rubbing(5.0), 60),
                  some = implicit_on(rubbing(0.2), 60);
  double before = 0.0;
  for (const EnergyBalance& balance : some.energies) {
    EXPECT_GE(balance.friction, before - 2e-4);  // of 10 J
    before = balance.friction;
  }
  EXPECT_GT(some.energies.back().friction, little.energies.back().friction);
  EXPECT_LT(stuck.energies.back().friction, 0.2 * some.energies.back().friction);
}

TEST(ImplicitContact, PlateOnASpringAsInTheOtherScheme) {
  FemProblem problem = test::common_case(15);
  problem.plate = {.stiffness = 2e6, .mass = 0.5, .damping_ratio = 0.1};
  const FemResult second = implicit_on(problem, 120), first = explicit_on(problem, 500);
  EXPECT_NEAR(second.restitution_momentum, first.restitution_momentum, 1e-3);
  EXPECT_NEAR(second.scalars.peak_deflection / first.scalars.peak_deflection, 1.0, 2e-3);
  EXPECT_NEAR(second.scalars.peak_force / first.scalars.peak_force, 1.0, 1e-2);
  const std::size_t sample = std::min(second.energies.size(), first.energies.size()) - 1;
  const EnergyBalance &a = second.energies[sample], &b = first.energies[sample];
  EXPECT_GT(b.plate_damper, 0.05);
  EXPECT_NEAR(a.plate_damper / b.plate_damper, 1.0, 0.01);
}

// Ball and free plate exchange momentum: m v = m u + M V, and e is of their relative speed.
TEST(ImplicitContact, FreePlateKeepsMomentum) {
  FemProblem problem = test::common_case(5);
  const double plate = 3.0 * problem.sphere.mass;
  problem.plate = {.stiffness = 1e-3, .mass = plate, .damping_ratio = 0.0};
  const FemResult result = implicit_on(problem, 60);
  const double rebound = 5.0 * result.restitution_momentum;  // of the ball, upwards
  const double speed_of_plate = problem.sphere.mass * (5.0 + rebound) / plate;
  EXPECT_NEAR(0.5 * plate * speed_of_plate * speed_of_plate / result.energies.back().plate_kinetic,
              1.0, 1e-6);
  EXPECT_NEAR((rebound + speed_of_plate) / 5.0, 0.99, 0.01);
}

TEST(ImplicitContact, AStiffPlateIsAWall) {
  FemProblem problem = test::common_case(15);
  const FemResult wall = implicit_on(problem, 60);
  problem.plate = {.stiffness = 1e11, .mass = 1.0, .damping_ratio = 0.5};
  const FemResult plate = implicit_on(problem, 60);
  EXPECT_NEAR(plate.restitution_momentum, wall.restitution_momentum, 2e-4);
  EXPECT_NEAR(plate.scalars.peak_deflection / wall.scalars.peak_deflection, 1.0, 1e-4);
}

CompressionResult pressed(double friction, double poisson_ratio, int steps) {
  const CompressionProblem problem{
      .sphere = {.mass = 0.0896, .diameter = 0.0662},
      .compression = {.platens = 2, .deflection = 2e-3, .steps = steps, .friction = friction},
      .material = {.youngs_modulus = 10e6, .poisson_ratio = poisson_ratio}};
  const Mesh mesh = generate_sphere_mesh(
      {.radius = 0.0331, .cells = 200, .grading = 10.0, .part = SpherePart::lower_half});
  CompressionResult result = run_static_compression(mesh, problem, {});
  EXPECT_EQ(result.incomplete_because, "");
  return result;
}

// Work of the platens is stored or lost by sliding. A contact that sticks is stiffer, by less than
// a flat punch that sticks is: ln(3 − 4ν)/(1 − 2ν) over 1/(1 − ν), 9.9 % at ν = 0 and 0.9 % at 0.4.
TEST(ImplicitContact, PlatensThatRub) {
  const CompressionResult smooth = pressed(0.0, 0.0, 40);
  EXPECT_EQ(smooth.curve.friction.back(), 0.0);
  for (const double friction : {0.05, 5.0}) {
    const CompressionResult rough = pressed(friction, 0.0, 40);
    const CompressionCurve& curve = rough.curve;
    EXPECT_NEAR((curve.stored.back() + curve.friction.back()) / curve.work.back(), 1.0, 1e-3);
    EXPECT_GT(curve.force.back() / smooth.curve.force.back(), 1.0) << friction;
    EXPECT_LT(curve.force.back() / smooth.curve.force.back(), std::log(3.0) + 1e-3) << friction;
    EXPECT_GE(curve.friction.back(), 0.0);
  }
  EXPECT_GT(pressed(0.05, 0.0, 40).curve.friction.back(), 1e-4 * smooth.curve.work.back());
}

}  // namespace
}  // namespace rebound::fem
