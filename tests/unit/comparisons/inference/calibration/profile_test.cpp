#include "comparisons/inference/calibration/profile.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/gaussian_noise.hpp"

namespace rebound {
namespace {

CalibrationProblem line(NoiseKnowledge noise) {
  test::GaussianNoise draw(11);
  std::vector<double> y;
  for (int t = 0; t < 20; ++t) y.push_back(2.0 - 0.3 * t + 0.1 * draw());
  CalibrationProblem problem;
  problem.parameters = {{.name = "a", .unit = "", .start = 0.0, .lowest = -10.0, .highest = 10.0},
                        {.name = "b", .unit = "", .start = 0.0, .lowest = -10.0, .highest = 10.0}};
  problem.residuals = [y](const std::vector<double>& x) {
    std::vector<double> r;
    for (int t = 0; t < 20; ++t)
      r.push_back((x[0] + x[1] * t - y[static_cast<std::size_t>(t)]) / 0.1);
    return r;
  };
  problem.noise = noise;
  problem.controls.profiles = Profiles::each_parameter;
  return problem;
}

// For a linear model the likelihood-ratio interval is the linearised one:
// F(1, ν) is the square of Student's t.
TEST(ProfileTest, EqualsLinearisedWhereTheModelIsLinear) {
  for (const auto noise : {NoiseKnowledge::known, NoiseKnowledge::estimated})
    for (const auto& e : calibrate(line(noise)).estimates) {
      ASSERT_TRUE(e.profile.has_value());
      EXPECT_TRUE(e.profile->low_closed && e.profile->high_closed);
      const double half = 0.5 * (e.high - e.low);
      EXPECT_NEAR(e.profile->low, e.low, 2e-3 * half);
      EXPECT_NEAR(e.profile->high, e.high, 2e-3 * half);
      EXPECT_GE(e.profile->value.size(), 3u);
    }
}

// y = exp(θ) ± 1 with one datum y = 2: the interval is ln(2 ± 1.96) above, and
// open below, since exp(θ) > 0.04 excludes little.
TEST(ProfileTest, FollowsACurvedModel) {
  CalibrationProblem problem;
  problem.parameters = {
      {.name = "theta", .unit = "", .start = 0.0, .lowest = -3.0, .highest = 5.0}};
  problem.residuals = [](const std::vector<double>& x) {
    return std::vector<double>{std::exp(x[0]) - 2.0};
  };
  problem.noise = NoiseKnowledge::known;
  problem.controls.profiles = Profiles::each_parameter;
  const auto found = calibrate(problem);
  const auto& profile = *found.estimates[0].profile;
  EXPECT_TRUE(profile.high_closed);
  EXPECT_NEAR(profile.high, std::log(2.0 + 1.959964), 2e-3);
  EXPECT_FALSE(profile.low_closed);
  EXPECT_EQ(found.estimates[0].identifiability, Identifiability::weakly_identified);
  EXPECT_NE(found.estimates[0].verdict.find("lower"), std::string::npos);
}

TEST(ProfileTest, OpenToBothSidesIsNotIdentifiable) {
  CalibrationProblem problem;
  problem.parameters = {{.name = "a", .unit = "", .start = 0.3, .lowest = 0.0, .highest = 1.0},
                        {.name = "b", .unit = "", .start = 0.0, .lowest = -9.0, .highest = 9.0}};
  problem.residuals = [](const std::vector<double>& x) {
    return std::vector<double>{x[1] - 1.0 + 0.5 * (x[0] - 0.5), 0.2 * (x[0] - 0.5), x[1] - 1.1};
  };
  problem.noise = NoiseKnowledge::known;
  problem.controls.profiles = Profiles::each_parameter;
  EXPECT_EQ(calibrate(problem).estimates[0].identifiability, Identifiability::not_identifiable);
}

TEST(ProfileTest, WeakParametersAreToldWhatWouldHelp) {
  CalibrationProblem problem;  // a and b nearly only as their sum
  problem.parameters = {{.name = "a", .unit = "", .start = 1.0, .lowest = -50.0, .highest = 50.0},
                        {.name = "b", .unit = "", .start = 1.0, .lowest = -50.0, .highest = 50.0}};
  problem.residuals = [](const std::vector<double>& x) {
    std::vector<double> r;
    for (int t = 0; t < 20; ++t) r.push_back(x[0] + x[1] * (1.0 + 0.01 * t) - 2.0 - 0.1 * (t % 2));
    return r;
  };
  problem.noise = NoiseKnowledge::known;
  const auto found = calibrate(problem);
  EXPECT_EQ(found.estimates[0].identifiability, Identifiability::weakly_identified);
  EXPECT_NE(found.estimates[0].verdict.find("trades against b"), std::string::npos);
  EXPECT_NE(found.verdict.find("weakly"), std::string::npos);
}

// A valley a b = 1 that is narrow and flat outside, as the tone of a ringing plate is: with b known
// to half an octave, a = 1/b is as well, and no more. A search that starts outside the valley finds
// no way back.
TEST(ProfileTest, FollowsANarrowValleyThatBends) {
  const double sigma = 0.5 * std::log(2.0);
  CalibrationProblem problem;
  problem.parameters = {
      {.name = "a", .unit = "", .start = 1.0, .lowest = 0.0, .highest = 20.0},
      {.name = "log b", .unit = "", .start = 0.0, .lowest = -5.0, .highest = 5.0}};
  problem.residuals = [&](const std::vector<double>& x) {
    return std::vector<double>{30.0 * std::tanh((std::log(x[0] + 1e-12) + x[1]) / 0.05),
                               x[1] / sigma};
  };
  problem.noise = NoiseKnowledge::known;
  const auto found = calibrate(problem);
  const auto profile = profile_of(problem, found, 0, {});
  ASSERT_TRUE(profile.low_closed && profile.high_closed);
  EXPECT_NEAR(profile.low, std::exp(-1.959964 * sigma), 0.02);
  EXPECT_NEAR(profile.high, std::exp(1.959964 * sigma), 0.05);
  // Both sides at once are the same walks.
  const CalibrationProblem above = problem;
  const auto at_once = profile_of(problem, above, found, 0, {});
  EXPECT_EQ(at_once.low, profile.low);
  EXPECT_EQ(at_once.high, profile.high);
  EXPECT_TRUE(at_once.low_closed && at_once.high_closed);
}

}  // namespace
}  // namespace rebound
