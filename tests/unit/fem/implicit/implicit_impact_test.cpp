// How an implicit impact ends when it does not end well, and what a complete
// one always brings.
#include "fem/implicit/implicit_impact.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lumped/problem/scalars.hpp"
#include "meshes/generate/sphere_mesh.hpp"
#include "tests/support/fem_cases.hpp"
#include "tests/support/refusals.hpp"

namespace rebound::fem {
namespace {

using test::common_case;

const Mesh& small_sphere() {
  static const Mesh mesh = generate_sphere_mesh({.radius = 0.0331, .cells = 60});
  return mesh;
}

FemResult run(const FemProblem& problem, const RunControl& control = {}) {
  return run_implicit_impact(small_sphere(), problem, control);
}

void expect_no_scalars(const FemResult& result) {
  EXPECT_EQ(result.scalars.restitution, 0.0);
  EXPECT_EQ(result.scalars.contact_time, 0.0);
  EXPECT_EQ(result.scalars.peak_force, 0.0);
  EXPECT_EQ(result.restitution_momentum, 0.0);
}

TEST(ImplicitImpactTest, MomentumAndEnergyClose) {
  for (const double gravity : {0.0, 9.81})
    for (const double speed : {0.1, 15.0}) {
      FemProblem problem = common_case(speed);
      problem.gravity = gravity;
      const FemResult result = run(problem);
      ASSERT_EQ(result.incomplete_because, "");
      EXPECT_LT(result.closures.impulse, 1e-6);
      EXPECT_LT(result.closures.energy, 1e-3);
      EXPECT_NEAR(result.scalars.restitution, result.restitution_momentum, 1e-6);
      EXPECT_NEAR(integral(result.trace.time, result.trace.force) /
                      (0.0896 * (speed * (1.0 + result.scalars.restitution) +
                                 gravity * result.scalars.contact_time)),
                  1.0, 1e-6);
      for (const double force : result.trace.force) EXPECT_GE(force, 0.0);
      EXPECT_EQ(result.trace.time.size(), result.energies.size());
    }
}

TEST(ImplicitImpactTest, BranchesTakeWhatRestitutionMisses) {
  FemProblem problem = common_case(15);
  problem.material.branches = {{0.4, 0.3e-3, Relaxes::all}};
  const FemResult result = run(problem);
  ASSERT_EQ(result.incomplete_because, "");
  const double brought = 0.5 * 0.0896 * 15.0 * 15.0;
  const double e = result.restitution_momentum;
  EXPECT_LT(e, 0.75);
  EXPECT_NEAR(1.0 - e * e,
              (result.energies.back().held + result.energies.back().dissipated) / brought +
                  result.vibrational_energy_share + result.contact_constraint_share,
              1e-3);
  for (const EnergyBalance& balance : result.energies)
    EXPECT_GT(balance.dissipated, -1e-4 * brought);
}

TEST(ImplicitImpactTest, TooShortAnEndTimeGivesNoScalars) {
  FemProblem problem = common_case(15);
  problem.controls.end_time = 0.5e-3;
  const FemResult result = run(problem);
  EXPECT_NE(result.incomplete_because.find("had not ended"), std::string::npos);
  EXPECT_GT(result.trace.time.size(), 10u);
  expect_no_scalars(result);
}

TEST(ImplicitImpactTest, InterruptionKeepsTheTraceAndNoScalars) {
  int asked = 0;
  RunControl control;
  control.interrupted = [&] { return ++asked == 30; };
  const FemResult result = run(common_case(15), control);
  EXPECT_EQ(result.incomplete_because, "interrupted");
  EXPECT_GE(result.trace.time.size(), 29u);
  expect_no_scalars(result);
}

TEST(ImplicitImpactTest, TooHighASpeedIsNoResult) {
  const FemResult result = run(common_case(400));  // five times the shear wave speed
  EXPECT_NE(result.incomplete_because, "");
  expect_no_scalars(result);
}

TEST(ImplicitImpactTest, RefusesWhatItDoesNotHave) {
  const auto key_refused = [](auto change) {
    FemProblem problem = common_case(15);
    change(problem);
    const Error error = testing::refusal_of([&] { run(problem); });
    EXPECT_EQ(error.code(), ExitCode::bad_input);
    return error.location().key;
  };
  EXPECT_EQ(key_refused([](FemProblem& p) {
              p.plate.stiffness = 1e6;
              p.adhesion.work = 1.0;
            }),
            "model.adhesion.work");
  EXPECT_EQ(key_refused([](FemProblem& p) { p.plate.friction = 5.1; }), "model.plate.friction");
  EXPECT_EQ(key_refused([](FemProblem& p) { p.material.retardation_time = 1e-6; }), "model.scheme");
  EXPECT_EQ(key_refused([](FemProblem& p) { p.material.layers = {{0.8, 2.0}}; }), "model.scheme");
  EXPECT_EQ(key_refused([](FemProblem& p) { p.impact.speed = -1.0; }), "impact.speed");
}

TEST(ImplicitImpactTest, SameInputSameBits) {
  const FemResult a = run(common_case(15)), b = run(common_case(15));
  EXPECT_EQ(a.trace.force, b.trace.force);
  EXPECT_EQ(a.scalars.restitution, b.scalars.restitution);
}

}  // namespace
}  // namespace rebound::fem
