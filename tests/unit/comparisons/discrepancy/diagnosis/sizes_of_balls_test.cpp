// Several balls: one size of an effect for all, or a size for every ball, as the data say.
#include <gtest/gtest.h>

#include "comparisons/discrepancy/diagnosis/believed_model.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

Dataset ball_with_hysteresis(double size, double mass, std::int64_t seed) {
  SynthesisFile file = testing::experiment_with({{"hysteresis", size, {}}}, seed);
  file.sphere.mass = mass;  // what tells the balls apart
  return synthesize(file, simulator_of(file, {})).dataset;
}

Diagnosis diagnose_two(double first, double second, std::int64_t seed) {
  DiagnosisRequest request;
  request.datasets = {ball_with_hysteresis(first, 90e-3, seed),
                      ball_with_hysteresis(second, 110e-3, seed + 100)};
  request.believed = testing::believed_law();
  request.ask_fem = false;
  return diagnose(request);
}

/// Is each size within its own interval, which leaves out the other?
bool tells_apart(const NamedEffect& effect, double first, double second) {
  if (effect.size_of_balls.size() != 2) return false;
  const auto holds = [](const NumberWithInterval& size, double value) {
    return size.low <= value && value <= size.high;
  };
  return holds(effect.size_of_balls[0], first) && holds(effect.size_of_balls[1], second) &&
         !holds(effect.size_of_balls[0], second) && !holds(effect.size_of_balls[1], first);
}

TEST(SizesOfBallsTest, DifferWhereTheDataSaySo) {
  int apart = 0;
  for (std::int64_t seed = 1; seed <= 5; ++seed) {
    const Diagnosis d = diagnose_two(0.1, 0.3, seed);
    if (d.verdict == DiagnosisVerdict::missing && d.effects.size() == 1 &&
        d.effects[0].effect.name == "hysteresis" && tells_apart(d.effects[0], 0.1, 0.3))
      ++apart;
  }
  EXPECT_GE(apart, 4);  // intervals hold the truth in 19 of 20, each
}

TEST(SizesOfBallsTest, AreOneWhereTheDataDoNotTellThemApart) {
  int shared = 0;
  for (std::int64_t seed = 1; seed <= 5; ++seed) {
    const Diagnosis d = diagnose_two(0.2, 0.2, seed);
    if (d.effects.size() == 1 && d.effects[0].effect.name == "hysteresis" &&
        d.effects[0].size_of_balls.empty())
      ++shared;
  }
  EXPECT_GE(shared, 4);
}

TEST(SizesOfBallsTest, StandInTheModelFileOfEachBall) {
  const Diagnosis d = diagnose_two(0.1, 0.3, 1);
  ASSERT_TRUE(d.extended());
  const auto& effects = d.best().effects;
  ASSERT_EQ(effects.size(), 1u);
  const auto size_in = [&](std::size_t ball) {
    const std::string file = extended_model_toml(d, ball);
    const std::size_t at = file.find("size = ");
    return at == std::string::npos ? 0.0 : std::stod(file.substr(at + 7));
  };
  EXPECT_NEAR(size_in(0), 0.1, 0.05);
  EXPECT_NEAR(size_in(1), 0.3, 0.05);
}

}  // namespace
}  // namespace rebound
