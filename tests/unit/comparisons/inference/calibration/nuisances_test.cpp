// Instrument errors hidden in synthetic records, and what must be refused.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "comparisons/inference/calibration/law_calibration.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/problem/error.hpp"
#include "tests/support/gaussian_noise.hpp"
#include "tests/support/lumped_cases.hpp"

namespace rebound {
namespace {

constexpr double noise = 5.0;

MeasuredImpact shot_at(double speed, const std::string& law = "hunt-crossley") {
  MeasuredImpact shot;
  shot.sphere = test::core_a();
  shot.impact = {.speed = speed, .separation = SeparationRule::zero_force};
  LumpedModel model;
  model.law = law;
  model.parameters = test::typical_parameters(law);
  const auto run = simulate({shot.sphere, shot.impact, model, {.samples = 201}});
  shot.trace = run.trace;
  shot.scalars = run.scalars;
  shot.noise.deviation = noise;
  return shot;
}

double force_at(const Trace& trace, double time) {
  if (time < 0.0 || time > trace.time.back()) return 0.0;
  const double at = time / trace.time.back() * static_cast<double>(trace.time.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(at), trace.time.size() - 2);
  return trace.force[i] + (at - static_cast<double>(i)) * (trace.force[i + 1] - trace.force[i]);
}

TEST(NuisanceTest, AreFoundAndSpareTheLaw) {
  test::GaussianNoise draw(3);
  std::vector<MeasuredImpact> shots;
  const double baseline[] = {12.0, -8.0}, trigger[] = {3e-5, -2e-5};
  for (std::size_t k = 0; k < 2; ++k) {
    MeasuredImpact shot = shot_at(k == 0 ? 5.0 : 15.0);
    const Trace clean = shot.trace;
    for (std::size_t i = 0; i < clean.time.size(); ++i)
      shot.trace.force[i] =
          force_at(clean, clean.time[i] - trigger[k]) + baseline[k] + noise * draw();
    shots.push_back(shot);
  }
  LawCalibrationOptions options;
  options.observable = Observable::force_time;
  const auto plain = calibrate_law("hunt-crossley", shots, {}, {}, options);
  options.nuisances = {{{"trigger", 5e-5}, {"baseline", 20.0}}};
  const auto found = calibrate_law("hunt-crossley", shots, {}, {}, options);
  const auto truth = test::typical_parameters("hunt-crossley");
  const auto miss = [&](const LawCalibration& c, const char* name) {
    return std::abs(c.model.parameters.at(name) / truth.at(name) - 1.0);
  };
  EXPECT_LT(miss(found, "stiffness"), 0.02);
  EXPECT_LT(miss(found, "damping"), 0.03);
  EXPECT_GT(miss(plain, "damping"), 0.05);
  EXPECT_FALSE(found.model.parameters.contains("baseline of shot 1"));
  for (const auto& e : found.fit.estimates) {
    if (e.name == "trigger of shot 1") {
      EXPECT_NEAR(e.value, 3e-5, 4.0 * e.standard_error);
    }
    if (e.name == "baseline of shot 2") {
      EXPECT_NEAR(e.value, -8.0, 4.0 * e.standard_error);
    }
  }
  EXPECT_EQ(found.fit.estimates.size(), 6u);
  EXPECT_LT(found.fit.reduced_chi_square, 1.3);
}

TEST(NuisanceTest, GainAndSpeedTradeAndArePriorHeld) {
  auto shots = std::vector{shot_at(15.0)};
  LawCalibrationOptions options;
  options.nuisances = {{{"gain", 0.03}, {"speed", 0.03}}};
  const auto found = calibrate_law("hunt-crossley", shots, {}, {}, options);
  EXPECT_NEAR(found.model.parameters.at("stiffness") / 3.5e6, 1.0, 0.02);
  EXPECT_GT(found.fit.estimates[0].standard_error / 3.5e6, 0.01);  // the gain's prior shows in κ
}

TEST(PerSpeedTest, DampingOfItsOwnAtEachSpeed) {
  std::vector<MeasuredImpact> shots;
  for (const auto& [speed, damping] : {std::pair{5.0, 30e4}, {15.0, 18e4}, {25.0, 12e4}}) {
    MeasuredImpact shot = shot_at(speed);
    LumpedModel model{.law = "hunt-crossley",
                      .parameters = {{"stiffness", 3.5e6}, {"damping", damping}}};
    shot.trace = simulate({shot.sphere, shot.impact, model, {}}).trace;
    shots.push_back(shot);
  }
  const auto found = calibrate({.law = "hunt-crossley", .per_speed = {"damping"}}, shots);
  EXPECT_NEAR(found.model.parameters.at("stiffness") / 3.5e6, 1.0, 1e-4);
  ASSERT_EQ(found.model.at_speed.size(), 3u);
  EXPECT_NEAR(found.model.at_speed[0].parameters.at("damping") / 30e4, 1.0, 1e-3);
  EXPECT_NEAR(found.model.at_speed[2].parameters.at("damping") / 12e4, 1.0, 1e-3);
  EXPECT_EQ(found.fit.estimates.size(), 4u);
  for (const auto& shot : shots)
    EXPECT_NO_THROW(simulate_fast({shot.sphere, shot.impact, found.model, {}}));
}

ExitCode code_of(const LawRequest& request, const std::vector<MeasuredImpact>& shots,
                 const LawCalibrationOptions& options = {}) {
  try {
    calibrate(request, shots, options);
  } catch (const Error& error) {
    return error.code();
  }
  return ExitCode::done;
}

TEST(BadReferenceTest, IsRefused) {
  const MeasuredImpact good = shot_at(15.0);
  const auto refused = [&](const auto& spoil) {
    MeasuredImpact bad = good;
    spoil(bad);
    for (const auto observable : {Observable::force_deflection, Observable::force_time}) {
      LawCalibrationOptions options;
      options.observable = observable;
      EXPECT_EQ(code_of({.law = "hunt-crossley"}, {bad}, options), ExitCode::bad_input);
    }
  };
  refused([](auto& s) { std::fill(s.trace.force.begin(), s.trace.force.end(), 7.0); });  // flat
  refused([](auto& s) { std::fill(s.trace.force.begin(), s.trace.force.end(), 0.0); });
  refused([](auto& s) { std::fill(s.trace.deflection.begin(), s.trace.deflection.end(), 1e-3); });
  refused([](auto& s) { std::swap(s.trace.time[3], s.trace.time[4]); });  // backwards
  refused([](auto& s) { s.trace.time[4] = s.trace.time[3]; });
  refused([](auto& s) { s.trace.force[9] = std::numeric_limits<double>::quiet_NaN(); });
  refused([](auto& s) {
    s.trace.time.resize(2), s.trace.force.resize(2), s.trace.deflection.resize(2);
  });
  refused([](auto& s) { s.trace.deflection.pop_back(); });
  EXPECT_EQ(code_of({.law = "hunt-crossley"}, {}), ExitCode::bad_input);
}

TEST(BadReferenceTest, RestitutionOfOneOrMoreHasNoFormula) {
  MeasuredImpact shot = shot_at(15.0);
  for (double e : {1.0, 1.4, 0.0, -0.2}) {
    shot.scalars.restitution = e;
    EXPECT_EQ(code_of({.law = "hunt-crossley", .damping_formula = "exact"}, {shot}),
              ExitCode::bad_input)
        << e;
  }
}

// Five samples, four unknowns of the law and two nuisances.
TEST(BadReferenceTest, FewDataIdentifyLittle) {
  std::vector<MeasuredImpact> shots;
  for (double speed : {5.0, 15.0}) {
    MeasuredImpact shot = shot_at(speed);
    MeasuredImpact few = shot;
    few.trace = {};
    for (std::size_t i : {20u, 60u, 100u, 140u, 180u}) {
      few.trace.time.push_back(shot.trace.time[i]);
      few.trace.force.push_back(shot.trace.force[i]);
      few.trace.deflection.push_back(shot.trace.deflection[i]);
    }
    shots.push_back(few);
  }
  shots.pop_back();
  LawRequest request{.law = "power-law"};
  request.free = {};
  LawCalibrationOptions options;
  options.nuisances = {{{"gain", 0.1}, {"baseline", 5.0}, {"speed", 0.1}}};
  // Priors count as data: nothing is refused, and nothing passes for identified by data alone.
  const auto found = calibrate(request, shots, options);
  int identified = 0;
  for (const auto& e : found.fit.estimates)
    identified += e.identifiability == Identifiability::identified;
  EXPECT_LT(identified, 5);
}

// Overdamped data under the rule that such a contact never ends by.
TEST(BadReferenceTest, OverdampedUnderZeroDeflectionIsNoResult) {
  MeasuredImpact shot = shot_at(15.0, "linear-kelvin-voigt");
  LumpedModel overdamped{
      .law = "linear-kelvin-voigt",
      .parameters = {{"stiffness", 2.5e5}, {"damping", 3.0 * 2.0 * std::sqrt(2.5e5 * 0.0896)}}};
  shot.trace = simulate({shot.sphere, shot.impact, overdamped, {}}).trace;
  shot.impact.separation = SeparationRule::zero_deflection;
  try {
    const auto found = calibrate({.law = "linear-kelvin-voigt"}, {shot});
    bool open = !found.fit.converged;
    for (const auto& e : found.fit.estimates)
      open |= e.identifiability == Identifiability::not_identifiable ||
              e.identifiability == Identifiability::at_bound;
    EXPECT_TRUE(open) << found.fit.estimates[1].value << " " << found.fit.estimates[1].verdict;
  } catch (const Error& error) {
    EXPECT_NE(error.code(), ExitCode::done);
  }
}

// Whatever the form an entry of the list is asked for in, its start means no error.
TEST(NuisanceListTest, StartsSayThatNothingIsWrong) {
  Nuisances asked;
  for (const NuisanceKind& kind : all_nuisances()) asked.deviation[kind.name] = 0.1;
  NuisanceUnknowns nuisances(2);
  std::vector<CalibrationParameter> unknowns;
  nuisances.add_asked(asked, unknowns);
  EXPECT_EQ(nuisances.places(0).size(), all_nuisances().size());
  std::vector<double> x;
  for (const auto& unknown : unknowns) x.push_back(unknown.start);
  MeasurementChain chain;
  nuisances.apply(x, 1, chain);
  EXPECT_EQ(chain, MeasurementChain{});
  for (std::size_t j = 0; j < x.size(); ++j) x[j] += 0.01;
  nuisances.apply(x, 1, chain);
  for (const NuisanceKind& kind : all_nuisances()) EXPECT_NE(chain.*kind.error, 0.0) << kind.name;
}

TEST(NuisanceListTest, DataStateThemForAllForBallsAndForShots) {
  Observations seen;
  seen.gain_uncertainty = 0.02;
  seen.balls = {{.name = "light", .sphere = test::core_a(), .mass_uncertainty = 1e-3},
                {.name = "heavy", .sphere = test::core_a(), .mass_uncertainty = 0.0}};
  for (const std::size_t ball : {0u, 1u}) {
    MeasuredImpact shot = shot_at(5.0);
    shot.label = seen.balls[ball].name;
    shot.ball = ball;
    shot.speed_uncertainty = 0.05;
    seen.shots.push_back(shot);
  }
  NuisanceUnknowns nuisances(2);
  std::vector<CalibrationParameter> unknowns;
  nuisances.add_stated(seen, unknowns);
  for (const std::size_t shot : {0u, 1u}) nuisances.add_stated_of_shot(seen, shot, unknowns);
  std::vector<std::string> names;
  for (const auto& unknown : unknowns) names.push_back(unknown.name);
  EXPECT_EQ(names, (std::vector<std::string>{"force gain", "force baseline", "mass error of light",
                                             "speed error, light", "speed error, heavy"}));
  MeasurementChain light, heavy;
  const std::vector<double> x{0.01, 2.0, 0.03, 0.04, 0.05};
  nuisances.apply(x, 0, light);
  nuisances.apply(x, 1, heavy);
  EXPECT_EQ(light.mass_error, 0.03);
  EXPECT_EQ(heavy.mass_error, 0.0);
  EXPECT_EQ(light.speed_error, 0.04);
  EXPECT_EQ(heavy.speed_error, 0.05);
  EXPECT_EQ(heavy.force_gain, 0.01);
  EXPECT_DOUBLE_EQ(unknowns[3].prior->deviation, 0.01);
}

TEST(NuisanceListTest, AnotherNameIsRefused) {
  LawCalibrationOptions options;
  options.nuisances = {{{"gian", 0.1}}};
  EXPECT_EQ(code_of({.law = "hunt-crossley"}, {shot_at(15.0)}, options), ExitCode::bad_input);
}

TEST(NuisanceTest, NeedKnownNoiseAndTheRightCurve) {
  MeasuredImpact shot = shot_at(15.0);
  LawCalibrationOptions options;
  options.nuisances = {{{"trigger", 1e-5}}};
  EXPECT_EQ(code_of({.law = "hunt-crossley"}, {shot}, options), ExitCode::bad_input);
  shot.noise.deviation = 0.0;
  options.observable = Observable::force_time;
  EXPECT_EQ(code_of({.law = "hunt-crossley"}, {shot}, options), ExitCode::bad_input);
}

}  // namespace
}  // namespace rebound
