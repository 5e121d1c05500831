// The second scheme against known answers, and against the first: bilinear
// cells, central differences and kinematic contact on one side, nine-node
// cells, generalised-α and an active set on the other.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "comparisons/accuracy/verification/targets.hpp"
#include "fem/implicit/implicit_impact.hpp"
#include "meshes/generate/sphere_mesh.hpp"
#include "tests/support/fem_impacts.hpp"

namespace rebound {
namespace {

FemResult implicit_impact(const Mesh& mesh, const FemProblem& problem) {
  FemResult result = fem::run_implicit_impact(mesh, problem, {});
  EXPECT_EQ(result.incomplete_because, "");
  EXPECT_LE(result.closures.impulse, 1e-6);
  EXPECT_LE(result.closures.energy, 1e-3);
  EXPECT_NEAR(result.scalars.restitution, result.restitution_momentum, 1e-6);
  return result;
}

// Case d; tolerances as in rung_d_test.cpp, contact time by the end of the force.
TEST(TwoSchemes, VerificationCaseD) {
  for (const auto& case_id : targets::sphere_impacts) {
    const FemProblem problem = test::common_case(case_id.speed);
    const FemResult result =
        implicit_impact(generate_sphere_mesh({.radius = problem.sphere.radius(),
                                              .cells = 250,
                                              .grading = targets::low_speed_grading}),
                        problem);
    EXPECT_NEAR(result.scalars.peak_force / case_id.force, 1.0, case_id.force_tolerance)
        << case_id.speed;
    EXPECT_NEAR(result.scalars.contact_time / case_id.time, 1.0, case_id.time_tolerance)
        << case_id.speed;
    EXPECT_GE(result.restitution_momentum, 0.998) << case_id.speed;
    EXPECT_LT(result.restitution_momentum, 1.0) << case_id.speed;
  }
}

// Case d′: a bar without lateral contraction; ρ c v, 2 L/c, e = 1. The front of
// the wave is a jump, behind which any second-order scheme rings: what is missing
// from e is that, and falls as a power 2/3 of cell and step.
TEST(TwoSchemes, VerificationCaseDBar) {
  const double area = std::numbers::pi * targets::bar_radius * targets::bar_radius;
  FemProblem problem;
  problem.sphere = {.mass = targets::bar_density * area * targets::bar_length,
                    .diameter = 2.0 * targets::bar_radius};
  problem.impact.speed = targets::bar_speed;
  problem.material = {.youngs_modulus = targets::bar_modulus, .poisson_ratio = 0.0};
  double missing[2];
  for (const int level : {0, 1}) {
    const int finer = level == 0 ? 1 : 3;
    problem.controls.output_interval = targets::bar_time / (200 * finer);
    const FemResult result = implicit_impact(cylinder_mesh({.radius = targets::bar_radius,
                                                            .length = targets::bar_length,
                                                            .cells_across = 1,
                                                            .cells_along = 50 * finer}),
                                             problem);
    double force = 0.0, samples = 0.0;
    for (std::size_t i = 0; i < result.trace.time.size(); ++i)
      if (std::abs(result.trace.time[i] / targets::bar_time - 0.5) < 0.3) {
        force += result.trace.force[i];
        samples += 1.0;
      }
    EXPECT_NEAR(force / samples / area / targets::bar_stress, 1.0, 2e-3);
    EXPECT_NEAR(result.scalars.contact_time / targets::bar_time, 1.0, 0.012 / finer + 1e-3);
    missing[level] = 1.0 - result.restitution_momentum;
  }
  EXPECT_LT(missing[1], 0.01);
  EXPECT_NEAR(std::log(missing[0] / missing[1]) / std::log(3.0), 2.0 / 3.0, 0.1);
}

// 15 m/s, with and without a branch. Either is a mesh of which the explicit
// error bar is 0.1 % in restitution and deflection, 0.5 % in force and time.
TEST(TwoSchemes, AgreeAtFifteenMetresPerSecond) {
  for (const double ratio : {0.0, 0.4}) {
    FemProblem problem = test::common_case(15.0);
    if (ratio > 0.0) problem.material.branches = {{ratio, 0.3e-3, Relaxes::all}};
    const auto mesh = [](int cells) {
      return generate_sphere_mesh({.radius = 0.0331, .cells = cells});
    };
    const FemResult second = implicit_impact(mesh(250), problem);
    const FemResult first = test::checked_impact(mesh(1000), problem);
    EXPECT_NEAR(second.restitution_momentum / first.restitution_momentum, 1.0, 1e-3);
    EXPECT_NEAR(second.scalars.peak_deflection / first.scalars.peak_deflection, 1.0, 2e-3);
    EXPECT_NEAR(second.scalars.peak_force / first.scalars.peak_force, 1.0, 1e-2);
    EXPECT_NEAR(second.scalars.contact_time_1pct / first.scalars.contact_time_1pct, 1.0, 1e-2);
    EXPECT_NEAR(second.scalars.mean_deflection / first.scalars.mean_deflection, 1.0, 1e-2);
  }
}

std::array<double, 3> compared(const FemResult& result) {
  return {result.restitution_momentum, result.scalars.peak_deflection / 1e-3,
          result.contact_time_tail / 1e-3};
}

// Rubber: cells that share a volume ratio against nine-node cells with a linear one. A bar is what
// a quarter of the cells changes. Restitution and deflection agree within 0.1 % besides.
TEST(TwoSchemes, AgreeForNearlyIncompressibleBodies) {
  for (const double poisson_ratio : {0.49, 0.499}) {
    FemProblem problem = test::common_case(5.0);
    problem.material.poisson_ratio = poisson_ratio;
    const auto mesh = [](int cells) {
      return generate_sphere_mesh({.radius = 0.0331, .cells = cells});
    };
    const auto second = [&](int cells) {
      const FemResult result = fem::run_implicit_impact(mesh(cells), problem, {});
      // Waves that the step does not follow are damped, and not counted among the losses.
      EXPECT_LE(result.closures.energy, cells > 100 ? 2e-3 : 4e-3);
      return compared(result);
    };
    const auto coarse = compared(test::checked_impact(mesh(300), problem));
    const auto fine = compared(test::checked_impact(mesh(1200), problem));
    const auto coarse_second = second(62), fine_second = second(250);
    for (std::size_t i = 0; i < fine.size(); ++i) {
      const double bars =
          std::abs(fine[i] - coarse[i]) + std::abs(fine_second[i] - coarse_second[i]);
      EXPECT_LE(std::abs(fine[i] - fine_second[i]), bars) << poisson_ratio << " " << i;
    }
    EXPECT_NEAR(fine_second[0], fine[0], 1e-3) << poisson_ratio;
    EXPECT_NEAR(fine_second[1] / fine[1], 1.0, 1e-3) << poisson_ratio;
  }
}

/// The field over the cells in which it is largest, and the frame nearest to `time`.
double largest_at(const ShapeHistory& shapes, ShapeQuantity quantity, double time) {
  std::size_t frame = 0;
  for (std::size_t i = 1; i < shapes.time.size(); ++i)
    if (std::abs(shapes.time[i] - time) < std::abs(shapes.time[frame] - time)) frame = i;
  for (const ShapeField& field : shapes.fields)
    if (field.quantity == quantity)
      return *std::max_element(field.values[frame].begin(), field.values[frame].end());
  ADD_FAILURE() << "the field is not there";
  return 0.0;
}

// Fields of the two schemes, found by ways that share the stress formulas alone. The
// largest stress and densities lie inside and agree within 1.6 %. The largest pressure lies
// at the plate, where it is a mean over a cell that depends on the cell's size (4 to 9 %, by the
// explicit scheme alone on the two meshes): the implicit one, on the coarse cells, must lie no
// farther from the fine mesh than the explicit one does there, and the 2 % of the other fields.
TEST(TwoSchemes, FieldsAgree) {
  FemProblem problem = test::common_case(15);
  problem.material.branches = {{0.3, 0.3e-3, Relaxes::all}};
  problem.controls.shape_frames = 60;
  const auto mesh = [&](int cells) {
    return generate_sphere_mesh({.radius = problem.sphere.radius(), .cells = cells});
  };
  const ShapeHistory first = test::checked_impact(mesh(1000), problem).shapes;
  const ShapeHistory same_cells = test::checked_impact(mesh(250), problem).shapes;
  const ShapeHistory second = implicit_impact(mesh(250), problem).shapes;
  for (const double time : {0.4e-3, 0.9e-3, 1.2e-3}) {
    const auto ratio = [&](ShapeQuantity quantity) {
      return largest_at(second, quantity, time) / largest_at(first, quantity, time);
    };
    for (const auto quantity :
         {ShapeQuantity::von_mises, ShapeQuantity::stored, ShapeQuantity::dissipated_or_held})
      EXPECT_NEAR(ratio(quantity), 1.0, 0.02) << time;
    const double coarse = largest_at(same_cells, ShapeQuantity::pressure, time) /
                          largest_at(first, ShapeQuantity::pressure, time);
    EXPECT_LE(std::abs(ratio(ShapeQuantity::pressure) - 1.0), std::abs(coarse - 1.0) + 0.02)
        << time;
  }
}

}  // namespace
}  // namespace rebound
