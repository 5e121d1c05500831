// How an explicit impact ends when it does not end well, and what a complete
// one always brings.
#include "fem/explicit/explicit_impact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "fem/interface/elastic_models.hpp"
#include "meshes/generate/sphere_mesh.hpp"
#include "tests/support/fem_cases.hpp"
#include "tests/support/refusals.hpp"

namespace rebound::fem {
namespace {

using test::common_case;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

const Discretisation& small_sphere() {
  static const Discretisation body =
      discretise(generate_sphere_mesh({.radius = 0.0331, .cells = 200}), 0.0896);
  return body;
}

void expect_no_scalars(const FemResult& result) {
  EXPECT_EQ(result.scalars.restitution, 0.0);
  EXPECT_EQ(result.scalars.contact_time, 0.0);
  EXPECT_EQ(result.scalars.peak_force, 0.0);
  EXPECT_EQ(result.restitution_momentum, 0.0);
}

void expect_all_finite(const FemResult& result) {
  const auto& s = result.scalars;
  for (const double value :
       {s.restitution, s.contact_time, s.contact_time_1pct, s.peak_force, s.peak_deflection,
        s.mean_deflection, s.rebound_speed, result.closures.impulse, result.closures.energy,
        result.restitution_momentum, result.contact_radius_peak, result.vibrational_energy_share,
        result.contact_constraint_share})
    EXPECT_TRUE(std::isfinite(value));
  for (const auto* column : {&result.trace.time, &result.trace.force, &result.trace.deflection})
    for (const double value : *column) ASSERT_TRUE(std::isfinite(value));
  for (const auto& column : result.trace.further)
    for (const double value : column.values) ASSERT_TRUE(std::isfinite(value));
}

TEST(ExplicitImpactTest, TooShortAnEndTimeGivesNoScalars) {
  FemProblem problem = common_case(15);
  problem.controls.end_time = 0.5e-3;
  const FemResult result = run_explicit_impact(small_sphere(), problem, {});
  EXPECT_NE(result.incomplete_because.find("had not ended"), std::string::npos);
  EXPECT_GT(result.trace.time.size(), 10u);
  EXPECT_LE(result.trace.time.back(), 0.51e-3);
  expect_no_scalars(result);
}

TEST(ExplicitImpactTest, InterruptionKeepsTheTraceAndNoScalars) {
  int asked = 0;
  double progress = 0.0;
  RunControl control;
  control.interrupted = [&] { return ++asked == 5; };
  control.progress = [&](double done) { progress = done; };
  const FemResult result = run_explicit_impact(small_sphere(), common_case(15), control);
  EXPECT_EQ(result.incomplete_because, "interrupted");
  EXPECT_EQ(asked, 5);
  EXPECT_GT(progress, 0.0);
  EXPECT_LT(progress, 1.0);
  EXPECT_GT(result.steps, 0);
  expect_no_scalars(result);
}

TEST(ExplicitImpactTest, SoftBallAtHighSpeedCompletes) {
  for (const auto elastic : {ElasticModel::neo_hookean, ElasticModel::neo_hookean_isochoric}) {
    FemProblem problem = common_case(25);
    problem.material.elastic = elastic;
    problem.material.youngs_modulus = 2e6;
    const FemResult result = run_explicit_impact(small_sphere(), problem, {});
    EXPECT_EQ(result.incomplete_because, "");
    expect_all_finite(result);
    EXPECT_GT(result.scalars.restitution, 0.5);
    EXPECT_LT(result.scalars.restitution, 1.0);
    // Time step error at two hundred cells; it falls as the cells get smaller.
    EXPECT_LT(result.closures.energy, 5e-3);
  }
}

TEST(ExplicitImpactTest, TooHighASpeedIsNoResult) {
  FemProblem problem = common_case(150);  // twice the shear wave speed
  const FemResult result = run_explicit_impact(small_sphere(), problem, {});
  EXPECT_NE(result.incomplete_because, "");
  expect_no_scalars(result);
}

TEST(ExplicitImpactTest, NotANumberIsNoResult) {
  // A mass that is no number makes every motion one; samples are so far apart
  // that none sees it.
  Discretisation body = small_sphere();
  body.mass[body.contact_nodes[2]] = nan;
  FemProblem problem = common_case(15);
  problem.controls.output_interval = 1.0;
  const FemResult result = run_explicit_impact(body, problem, {});
  EXPECT_EQ(result.incomplete_because, "the motion is no longer finite");
  expect_no_scalars(result);
}

TEST(ExplicitImpactTest, RefusesTheZeroDeflectionRule) {
  FemProblem problem = common_case(15);
  problem.impact.separation = SeparationRule::zero_deflection;
  const Error error =
      testing::refusal_of([&] { run_explicit_impact(small_sphere(), problem, {}); });
  EXPECT_EQ(error.code(), ExitCode::bad_input);
  EXPECT_EQ(error.location().key, "impact.separation");
}

TEST(ExplicitImpactTest, RefusesNumbersOutOfRange) {
  const auto key_refused = [](auto change) {
    FemProblem problem = common_case(15);
    change(problem);
    const Error error =
        testing::refusal_of([&] { run_explicit_impact(small_sphere(), problem, {}); });
    EXPECT_EQ(error.code(), ExitCode::bad_input);
    return error.location().key;
  };
  for (const double bad : {-1.0, nan, infinity}) {
    EXPECT_EQ(key_refused([&](FemProblem& p) { p.sphere.mass = bad; }), "sphere.mass");
    EXPECT_EQ(key_refused([&](FemProblem& p) { p.sphere.diameter = bad; }), "sphere.diameter");
    EXPECT_EQ(key_refused([&](FemProblem& p) { p.impact.speed = bad; }), "impact.speed");
    EXPECT_EQ(key_refused([&](FemProblem& p) { p.controls.step_safety = bad; }),
              "controls.step_safety");
    EXPECT_EQ(key_refused([&](FemProblem& p) { p.controls.end_time = bad; }), "controls.end_time");
    EXPECT_EQ(key_refused([&](FemProblem& p) { p.controls.output_interval = bad; }),
              "controls.output_interval");
  }
  for (const double bad : {-1.0, nan, infinity}) {
    EXPECT_EQ(key_refused([&](FemProblem& p) { p.gravity = bad; }), "impact.gravity");
    EXPECT_EQ(key_refused([&](FemProblem& p) { p.plate = {.stiffness = 1e6, .mass = bad}; }),
              "model.plate.mass");
    EXPECT_EQ(
        key_refused([&](FemProblem& p) { p.plate = {.stiffness = 1e6, .damping_ratio = bad}; }),
        "model.plate.damping_ratio");
    EXPECT_EQ(key_refused([&](FemProblem& p) { p.plate.friction = bad; }), "model.plate.friction");
  }
  for (const double bad : {-1.0, 0.0, nan})
    EXPECT_EQ(key_refused([&](FemProblem& p) { p.plate.stiffness = bad; }),
              "model.plate.stiffness");
  EXPECT_EQ(key_refused([](FemProblem& p) { p.controls.output_interval = 1e-12; }),
            "controls.output_interval");
  EXPECT_EQ(key_refused([](FemProblem& p) { p.material.poisson_ratio = 0.4995; }),
            "model.material.poisson_ratio");
}

TEST(ExplicitImpactTest, SameInputSameBits) {
  const FemResult a = run_explicit_impact(small_sphere(), common_case(15), {});
  const FemResult b = run_explicit_impact(small_sphere(), common_case(15), {});
  EXPECT_EQ(a.trace.force, b.trace.force);
  EXPECT_EQ(a.scalars.restitution, b.scalars.restitution);
}

TEST(ExplicitImpactTest, OutputIntervalDoesNotChangeTheMotion) {
  FemProblem problem = common_case(15);
  const FemResult fine = run_explicit_impact(small_sphere(), problem, {});
  problem.controls.output_interval = 50e-6;
  const FemResult coarse = run_explicit_impact(small_sphere(), problem, {});
  EXPECT_EQ(fine.scalars.contact_time, coarse.scalars.contact_time);
  // The end is looked for with the latest energies, so the count of steps may differ.
  EXPECT_NEAR(fine.restitution_momentum, coarse.restitution_momentum, 1e-6);
  EXPECT_LT(coarse.closures.impulse, 1e-12);
}

TEST(ExplicitImpactTest, WritesFieldsForParaView) {
  const auto folder = std::filesystem::temp_directory_path() / "rebound-fields-test";
  std::filesystem::remove_all(folder);
  FemProblem problem = common_case(15);
  problem.controls.field_frames = 8;
  problem.controls.field_directory = folder.string();
  ASSERT_EQ(run_explicit_impact(small_sphere(), problem, {}).incomplete_because, "");
  ASSERT_TRUE(std::filesystem::exists(folder / "frame-0004.vtu"));
  std::ifstream list(folder / "impact.pvd");
  const std::string text((std::istreambuf_iterator<char>(list)), {});
  EXPECT_NE(text.find("frame-0000.vtu"), std::string::npos);
  EXPECT_NE(text.find("frame-0004.vtu"), std::string::npos);
  std::filesystem::remove_all(folder);

  problem.controls.field_directory = "/proc/no-such-folder/fields";
  EXPECT_EQ(testing::refusal_of([&] { run_explicit_impact(small_sphere(), problem, {}); }).code(),
            ExitCode::input_output_failed);
}

}  // namespace
}  // namespace rebound::fem
