#include "comparisons/inference/calibration/material_calibration.hpp"

#include <gtest/gtest.h>

#include "fem/discretisation/discretisation.hpp"
#include "fem/explicit/explicit_impact.hpp"
#include "lumped/problem/scalars.hpp"
#include "meshes/generate/sphere_mesh.hpp"
#include "tests/support/refusals.hpp"

namespace rebound {
namespace {

FemProblem ball() {
  FemProblem problem;
  problem.sphere = {.mass = 89.6e-3, .diameter = 66.2e-3};
  problem.material.youngs_modulus = 6e6;
  problem.material.poisson_ratio = 0.4;
  problem.material.modulus = ModulusBasis::long_term;
  problem.material.branches = {{.ratio = 0.8, .relaxation_time = 0.4e-3}};
  return problem;
}

FemRunner runner(const FemProblem& problem) {
  const Mesh mesh = generate_sphere_mesh({.radius = problem.sphere.radius(), .cells = 150});
  const auto body =
      std::make_shared<fem::Discretisation>(fem::discretise(mesh, problem.sphere.mass));
  return [body](const FemProblem& one) { return fem::run_explicit_impact(*body, one, {}); };
}

std::vector<MeasuredImpact> impacts_of(const FemProblem& problem, const FemRunner& run) {
  std::vector<MeasuredImpact> measured;
  for (const double speed : {5.0, 20.0}) {
    FemProblem one = problem;
    one.impact.speed = speed;
    const FemResult result = run(one);
    measured.push_back({.impact = one.impact,
                        .contact_threshold = 10.0,
                        .restitution = {result.scalars.restitution, 0.01},
                        .contact_time = {time_above(result.trace, 10.0), 0.03e-3}});
  }
  return measured;
}

TEST(MaterialCalibrationTest, DifferencesHaveOneStep) {
  // A step below all stable ones holds to the end, for materials a difference apart.
  FemProblem problem = ball();
  const FemRunner run = runner(problem);
  problem.impact.speed = 20.0;
  const double free = run(problem).smallest_step;
  problem.controls.largest_step = 0.9 * free;
  const FemResult below = run(problem);
  problem.material.branches[0].ratio *= 1.02;
  const FemResult above = run(problem);
  EXPECT_EQ(below.smallest_step, 0.9 * free);
  EXPECT_EQ(above.smallest_step, 0.9 * free);
}

TEST(MaterialCalibrationTest, RecoversABranch) {
  const FemProblem truth = ball();
  const FemRunner run = runner(truth);
  FemProblem start = truth;
  start.material.branches[0] = {.ratio = 0.4, .relaxation_time = 0.8e-3};
  const auto found = calibrate_material(start, impacts_of(truth, run),
                                        {{MaterialUnknown::branch_ratio, 0, 0.02, 10.0},
                                         {MaterialUnknown::branch_time, 0, 0.02e-3, 10e-3}},
                                        run);
  EXPECT_TRUE(found.fit.converged);
  // Far inside the intervals that the stated uncertainties give (20 % and more):
  // what is left is where the search stops in the ripple of the scheme.
  EXPECT_NEAR(found.material.branches[0].ratio / 0.8, 1.0, 0.03);
  EXPECT_NEAR(found.material.branches[0].relaxation_time / 0.4e-3, 1.0, 0.05);
  EXPECT_LT(found.fit.reduced_chi_square, 0.05);
}

TEST(MaterialCalibrationTest, RefusesFewerDataThanUnknowns) {
  const FemProblem truth = ball();
  const FemRunner run = runner(truth);
  auto measured = impacts_of(truth, run);
  measured.resize(1);
  const Error error = testing::refusal_of([&] {
    calibrate_material(truth, measured,
                       {{MaterialUnknown::youngs_modulus, 0, 1e6, 1e8},
                        {MaterialUnknown::branch_ratio, 0, 0.02, 10.0},
                        {MaterialUnknown::branch_time, 0, 0.02e-3, 10e-3}},
                       run);
  });
  EXPECT_EQ(error.code(), ExitCode::bad_input);
}

TEST(MaterialCalibrationTest, FailuresOfARunReachTheCaller) {
  const FemProblem truth = ball();
  const FemRunner broken = [](const FemProblem&) -> FemResult {
    throw Error(ExitCode::interrupted, "stop");
  };
  const Error error = testing::refusal_of([&] {
    run_impacts(truth, {{.speed = 5.0}, {.speed = 6.0}}, broken);
  });
  EXPECT_EQ(error.code(), ExitCode::interrupted);
}

}  // namespace
}  // namespace rebound
