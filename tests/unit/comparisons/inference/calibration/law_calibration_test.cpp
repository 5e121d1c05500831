// Laws fitted to traces that the lumped tier synthesised, so the truth is known.
#include "comparisons/inference/calibration/law_calibration.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lumped/integration/closed_forms.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/laws/laws.hpp"
#include "lumped/problem/error.hpp"
#include "tests/support/gaussian_noise.hpp"
#include "tests/support/lumped_cases.hpp"

namespace rebound {
namespace {

MeasuredImpact shot_of(const LumpedModel& model, double speed, int samples = 201) {
  MeasuredImpact shot;
  shot.sphere = test::core_a();
  shot.impact = {.speed = speed, .separation = SeparationRule::zero_force};
  const LumpedResult run = simulate({.sphere = shot.sphere,
                                     .impact = shot.impact,
                                     .model = model,
                                     .controls = {.relative_tolerance = 1e-9, .samples = samples}});
  shot.trace = run.trace;
  shot.scalars = run.scalars;
  return shot;
}

LumpedModel model_of(const std::string& law, ParameterValues parameters) {
  LumpedModel model;
  model.law = law;
  model.parameters = std::move(parameters);
  return model;
}

/// Core A with the damping its measured restitutions need exactly.
std::vector<MeasuredImpact> core_a_shots(double stiffness) {
  std::vector<MeasuredImpact> shots;
  for (const auto& [speed, e] : {std::pair{5.0, 0.606}, {15.0, 0.527}, {25.0, 0.462}}) {
    LumpedModel model = model_of("hunt-crossley", {{"stiffness", stiffness}});
    model.restitution = e;
    model.damping_formula = "exact";
    shots.push_back(shot_of(model, speed));
  }
  return shots;
}

TEST(LawCalibrationTest, RecoversStiffness) {
  const auto shots = core_a_shots(3.5e6);
  const LawCalibration found = calibrate_hunt_crossley(shots, "exact");
  EXPECT_TRUE(found.fit.converged);
  EXPECT_NEAR(found.fit.estimates[0].value / 3.5e6, 1.0, 1e-5);
  EXPECT_EQ(found.fit.estimates[0].unit, "N/m^1.5");
  EXPECT_LT(found.fit.cost_after, 1e-6 * found.fit.cost_before);
  // The calibrated model simulates: it returns the restitutions it was given.
  ASSERT_EQ(found.model.at_speed.size(), 3u);
  for (const auto& shot : shots) {
    const auto run = simulate_fast({shot.sphere, shot.impact, found.model, {}});
    EXPECT_NEAR(run.scalars.restitution, shot.scalars.restitution, 1e-7);
  }
}

// As the paper did: λ by its Eq. (8). On traces that really lose what was
// measured, the formula leaves too much restitution and bends κ upwards or
// downwards; the exact relation does not.
TEST(LawCalibrationTest, PaperFormulaLeavesRestitutionTooHigh) {
  const auto shots = core_a_shots(3.5e6);
  const LawCalibration paper = calibrate_hunt_crossley(shots, "hunt-crossley");
  const LawCalibration exact = calibrate_hunt_crossley(shots, "exact");
  EXPECT_GT(paper.fit.cost_after, 100.0 * exact.fit.cost_after);
  for (const auto& shot : shots) {
    const auto run = simulate_fast({shot.sphere, shot.impact, paper.model, {}});
    EXPECT_GT(run.scalars.restitution, shot.scalars.restitution + 0.08);
  }
  EXPECT_FALSE(paper.fit.warnings.empty());  // model error, and said so
}

TEST(LawCalibrationTest, WeightingDecidesWhichSpeedCounts) {
  const auto shots = core_a_shots(3.5e6);
  const auto absolute = calibrate_hunt_crossley(shots, "hunt-crossley");
  const auto of_peak = calibrate_hunt_crossley(shots, "hunt-crossley",
                                               {.weighting = Weighting::of_peak, .controls = {}});
  EXPECT_GT(std::abs(absolute.fit.estimates[0].value / of_peak.fit.estimates[0].value - 1.0), 1e-3);
}

TEST(LawCalibrationTest, RecoversKelvinVoigt) {
  const auto shot =
      shot_of(model_of("linear-kelvin-voigt", {{"stiffness", 2.5e5}, {"damping", 60.0}}), 15.0);
  const auto found = calibrate_law("linear-kelvin-voigt", {shot}, {});
  EXPECT_NEAR(found.model.parameters.at("stiffness") / 2.5e5, 1.0, 1e-5);
  EXPECT_NEAR(found.model.parameters.at("damping") / 60.0, 1.0, 1e-4);
  EXPECT_EQ(found.fit.estimates[1].unit, "N.s/m");
}

TEST(LawCalibrationTest, RecoversAFreeExponent) {
  std::vector<MeasuredImpact> shots;
  for (double speed : {5.0, 25.0})
    shots.push_back(shot_of(
        model_of("hunt-crossley", {{"exponent", 1.3}, {"stiffness", 1e6}, {"damping", 5e4}}),
        speed));
  const auto found = calibrate_law("hunt-crossley", shots, {}, {"exponent"});
  EXPECT_NEAR(found.model.parameters.at("exponent"), 1.3, 1e-4);
  EXPECT_NEAR(found.model.parameters.at("stiffness") / 1e6, 1.0, 1e-3);
  EXPECT_NEAR(found.model.parameters.at("damping") / 5e4, 1.0, 1e-3);
}

TEST(LawCalibrationTest, RecoversEveryLaw) {
  const std::map<std::string, ParameterValues> held = {
      {"equivalent-kelvin-voigt", {{"representative_deflection", 3.97e-3}}}};
  for (const auto& card : all_laws()) {
    const auto truth = test::typical_parameters(card.name);
    const auto shots = std::vector{shot_of(model_of(card.name, truth), 5.0),
                                   shot_of(model_of(card.name, truth), 15.0)};
    const auto fixed = held.contains(card.name) ? held.at(card.name) : ParameterValues{};
    const auto found = calibrate_law(card.name, shots, fixed);
    for (const auto& [name, value] : truth)
      if (found.model.parameters.contains(name)) {
        EXPECT_NEAR(found.model.parameters.at(name) / value, 1.0, 2e-3) << card.name << " " << name;
      }
  }
}

// κ, λ and x_R enter the equivalent law only as k_eq and c_eq.
TEST(LawCalibrationTest, NamesTheUnidentifiable) {
  const auto shot =
      shot_of(model_of("linear-kelvin-voigt", {{"stiffness", 2.5e5}, {"damping", 60.0}}), 15.0);
  const auto found = calibrate_law("equivalent-kelvin-voigt", {shot}, {});
  ASSERT_EQ(found.fit.estimates.size(), 3u);
  for (const auto& estimate : found.fit.estimates) {
    EXPECT_EQ(estimate.identifiability, Identifiability::not_identifiable) << estimate.name;
    EXPECT_NE(estimate.verdict.find("combination of"), std::string::npos);
  }
  EXPECT_NE(found.fit.verdict.find("0 of 3"), std::string::npos);
}

// 400 seeded repetitions; the number of 95 % intervals that hold the truth is
// binomial with mean 380 and deviation 4.4: four deviations either way.
TEST(LawCalibrationTest, IntervalsCoverTheTruth) {
  LumpedModel truth = model_of("hunt-crossley", {{"stiffness", 3.5e6}, {"damping", 17.63e4}});
  const MeasuredImpact clean = shot_of(truth, 15.0, 101);
  for (const bool noise_known : {true, false}) {
    int covered[2] = {0, 0};
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
      MeasuredImpact shot = clean;
      test::GaussianNoise noise(seed);
      for (double& force : shot.trace.force) force += 30.0 * noise();
      shot.noise.deviation = noise_known ? 30.0 : 0.0;
      const auto found = calibrate_law("hunt-crossley", {shot}, {});
      for (int i : {0, 1}) {
        const auto& e = found.fit.estimates[static_cast<std::size_t>(i)];
        const double value = truth.parameters.at(e.name);
        covered[i] += e.low <= value && value <= e.high;
      }
    }
    for (int count : covered) {
      EXPECT_GE(count, 362) << (noise_known ? "known" : "estimated");
      EXPECT_LE(count, 398) << (noise_known ? "known" : "estimated");
    }
  }
}

TEST(LawCalibrationTest, LinearisesAtTheMeanDeflection) {
  const auto shots = core_a_shots(3.5e6);
  const LawCalibration found = calibrate_hunt_crossley(shots, "exact");
  const LumpedModel linear = linearise_at_mean_deflection(found.model, shots);
  for (std::size_t i = 0; i < shots.size(); ++i) {
    const double x = shots[i].scalars.mean_deflection;
    const double damping = found.model.at_speed[i].parameters.at("damping");
    EXPECT_EQ(linear.at_speed[i].parameters.at("representative_deflection"), x);
    const auto run = simulate_fast({shots[i].sphere, shots[i].impact, linear, {}});
    const KelvinVoigtImpact exact(
        {.stiffness = 3.5e6 * std::sqrt(x), .damping = damping * x * std::sqrt(x)},
        {.mass = shots[i].sphere.mass, .speed = shots[i].impact.speed});
    EXPECT_NEAR(run.scalars.restitution, exact.restitution(SeparationRule::zero_force), 1e-5);
  }
}

TEST(LawCalibrationTest, RepeatedShotsShareOneEntry) {
  auto shots = core_a_shots(3.5e6);
  shots.push_back(shots[1]);
  shots.back().scalars.restitution += 0.02;
  const LawCalibration found = calibrate_hunt_crossley(shots, "hunt-crossley");
  ASSERT_EQ(found.model.at_speed.size(), 3u);
  const double stiffness = found.fit.estimates[0].value;
  EXPECT_NEAR(found.model.at_speed[1].parameters.at("damping"),  // mean of e: 0.537
              1.5 * (1.0 - 0.537) * stiffness / 15.0, 1.0);
  EXPECT_EQ(linearise_at_mean_deflection(found.model, shots).at_speed.size(), 3u);
}

TEST(LawCalibrationTest, RequestsMeanTheNamedCalibrations) {
  const auto shots = core_a_shots(3.5e6);
  const double direct = calibrate_hunt_crossley(shots, "exact").fit.estimates[0].value;
  const LawRequest asked{
      .law = "hunt-crossley", .damping_formula = "exact", .fixed = {}, .free = {}};
  EXPECT_EQ(calibrate(asked, shots).fit.estimates[0].value, direct);
  LawRequest equivalent = asked;
  equivalent.law = "equivalent-kelvin-voigt";
  EXPECT_EQ(calibrate(equivalent, shots).model.law, "equivalent-kelvin-voigt");
  EXPECT_EQ(calibrate(equivalent, shots).model.parameters.at("stiffness"), direct);
  LawRequest held{
      .law = "hunt-crossley", .damping_formula = "", .fixed = {{"damping", 1e5}}, .free = {}};
  EXPECT_EQ(calibrate(held, shots).fit.estimates.size(), 1u);
  held.damping_formula = "exact";
  EXPECT_THROW(calibrate(held, shots), Error);
  LawRequest other = asked;
  other.law = "hertz-damped";
  EXPECT_THROW(calibrate(other, shots), Error);
}

TEST(LawCalibrationTest, RefusesWhatCannotBeFitted) {
  auto shots = core_a_shots(3.5e6);
  EXPECT_THROW(calibrate_hunt_crossley({}, "exact"), Error);
  EXPECT_THROW(calibrate_hunt_crossley(shots, "magic"), Error);
  EXPECT_THROW(calibrate_law("hunt-crossley", shots, {{"stiffness", 3e6}, {"damping", 1e5}}),
               Error);
  EXPECT_THROW(calibrate_law("hunt-crossley", shots, {{"colour", 3e6}}), Error);
  shots[1].trace.deflection.clear();
  EXPECT_THROW(calibrate_hunt_crossley(shots, "exact"), Error);
}

}  // namespace
}  // namespace rebound
