#include "comparisons/discrepancy/diagnosis/verdict/shots_that_differ.hpp"

#include <gtest/gtest.h>

#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

using Candidates = std::vector<std::vector<std::string>>;

/// Five speeds, one after the other, and so again.
SynthesisFile five_speeds(const EffectChoice& hidden, int repeats, std::int64_t seed) {
  SynthesisFile file = testing::experiment_with({hidden}, seed);
  file.shots.clear();
  for (int repeat = 0; repeat < repeats; ++repeat)
    for (const double speed : {5.0, 10.0, 15.0, 20.0, 25.0})
      file.shots.push_back({.speed = speed, .speed_uncertainty = 0.004 * speed});
  return file;
}

TEST(ShotsThatDifferTest, ABallThatChangesIsUnexplained) {
  for (int seed = 1; seed <= 3; ++seed) {
    const Diagnosis d = testing::diagnose_hidden(five_speeds({"ageing", -0.005, {}}, 2, seed));
    EXPECT_EQ(d.verdict, DiagnosisVerdict::unexplained);
    EXPECT_EQ(d.candidates, (Candidates{{"ageing"}}));
    EXPECT_NE(d.withheld.find("order of the shots"), std::string::npos) << d.withheld;
  }
}

// With a repeat it is a fault of that shot -> MeasurementFaultTest.AnOddShotAmongRepeats...
TEST(ShotsThatDifferTest, AnOddShotWithoutARepeatIsNoFault) {
  const EffectChoice hidden{"odd-shot", -0.1, {{"shot", 4.0}, {"time_exponent", -1.0}}};
  for (int seed = 1; seed <= 3; ++seed) {
    const Diagnosis d = testing::diagnose_hidden(five_speeds(hidden, 1, seed));
    EXPECT_EQ(d.verdict, DiagnosisVerdict::unexplained);
    EXPECT_EQ(d.candidates, (Candidates{{"odd-shot"}}));
    EXPECT_NE(d.withheld.find("repeat it"), std::string::npos) << d.withheld;
  }
}

/// What is left of candidates with these effects, in their order.
std::vector<std::size_t> left_of(const std::vector<std::string>& names) {
  Diagnosis d;
  for (const std::string& name : names) {
    AssessedFit one;
    one.fit.effects = {{.name = name, .size = 0.1, .parameters = {}}};
    d.selection.indistinguishable.push_back(d.selection.tried.size());
    d.selection.tried.push_back(one);
  }
  prefer_a_ball_that_stays(d);
  return d.selection.indistinguishable;
}

// Where shots come in the order of their speeds, a ball that changes looks like one that is stiffer
// at speed.
TEST(ShotsThatDifferTest, AChangingBallIsNoCandidateBesideOthers) {
  EXPECT_EQ(left_of({"ageing", "rate-stiffening"}), std::vector<std::size_t>{1});
  EXPECT_EQ(left_of({"rate-stiffening", "ageing", "relaxation"}), (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(left_of({"ageing"}), std::vector<std::size_t>{0});
}

}  // namespace
}  // namespace rebound
