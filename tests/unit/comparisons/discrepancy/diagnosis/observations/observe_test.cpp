#include "comparisons/discrepancy/diagnosis/observations/observe.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "comparisons/discrepancy/diagnosis/observations/settle_noise.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

Dataset synthetic(const SynthesisFile& file) {
  return synthesize(file, simulator_of(file, {})).dataset;
}

TEST(ObserveTest, NoiseIsTakenFromBeforeContactWhereNoneIsStated) {
  SynthesisFile file = testing::experiment_with({}, 3);
  Dataset dataset = synthetic(file);
  dataset.instrument.force_noise.reset();
  const Observations seen = observe({dataset});
  ASSERT_TRUE(seen.shots[0].has_history());
  EXPECT_NEAR(seen.shots[0].noise.deviation, 20.0, 7.5);  // three standard errors of 30 samples
  EXPECT_NE(seen.noise_from.find("before contact"), std::string::npos);
}

// The mean of n samples: σ/√n, and √((1 + ρ)/(1 − ρ)) times that where neighbours are alike by ρ.
TEST(ObserveTest, TheZeroIsTheMeanOfTheQuietAndKnownAsWellAsItsSamplesTell) {
  PreparedRecord record;
  record.contact.first = 100;
  for (int i = 0; i < 150; ++i) record.trace.force.push_back(i < 100 ? 2.5 + i % 2 : 900.0);
  ForceNoise white{.deviation = 10.0};
  settle_zero(record, white);
  EXPECT_NEAR(white.zero, 3.0, 1e-12);
  EXPECT_NEAR(white.zero_error, 1.0, 1e-12);
  ForceNoise coloured{.deviation = 10.0, .autocorrelation = {0.5}};
  settle_zero(record, coloured);
  EXPECT_NEAR(coloured.zero_error, std::sqrt(3.0), 0.02);
}

TEST(ObserveTest, WithoutAnyNoiseItSaysWhatIsMissing) {
  SynthesisFile file = testing::experiment_with({}, 3);
  file.sampling.before = 0.0;
  Dataset dataset = synthetic(file);
  dataset.instrument.force_noise.reset();
  EXPECT_FALSE(observe({dataset}).missing.empty());
}

TEST(ObserveTest, FastSamplingIsAveragedWithItsNoise) {
  SynthesisFile file = testing::experiment_with({}, 3);
  file.sampling.rate = 2e6;
  const Observations seen = observe({synthetic(file)});
  EXPECT_LT(seen.shots[0].trace.time.size(), 1500u);
  EXPECT_LT(seen.shots[0].noise.deviation, 10.0);
}

/// Noise that is averaged over two samples has another colour than what is not: one colour is
/// found for all records.
TEST(ObserveTest, RecordsOfOneDataSetAreAveragedAlike) {
  for (const double rate : {0.8e6, 1.0e6, 1.2e6, 1.5e6, 2.3e6}) {
    SynthesisFile file = testing::experiment_with({}, 3);
    file.sampling.rate = rate;
    const Observations seen = observe({synthetic(file)});
    for (const MeasuredImpact& shot : seen.shots)
      EXPECT_NEAR(shot.trace.time[1] - shot.trace.time[0],
                  seen.shots[0].trace.time[1] - seen.shots[0].trace.time[0], 1e-9)
          << rate;
  }
}

TEST(ObserveTest, RepeatsHaveNamesOfTheirOwn) {
  SynthesisFile file = testing::experiment_with({}, 3);
  file.shots.push_back(file.shots.front());
  const Dataset dataset = synthetic(file);
  const Observations seen = observe({dataset, dataset});
  std::set<std::string> labels;
  for (const MeasuredImpact& shot : seen.shots) labels.insert(shot.label);
  EXPECT_EQ(labels.size(), 8u);
}

TEST(ObserveTest, ShotsAreNumberedOverAllThatTheDataHold) {
  Dataset dataset = synthetic(testing::experiment_with({}, 3));
  dataset.shots[1].trace = {};  // nothing is seen of it, and its number stays its own
  const Observations seen = observe({dataset, dataset});
  std::vector<int> numbers;
  for (const MeasuredImpact& shot : seen.shots) numbers.push_back(shot.number);
  EXPECT_EQ(numbers, (std::vector<int>{1, 3, 4, 6}));
}

TEST(ObserveTest, OneBallInTwoDataSetsIsOne) {
  const Dataset dataset = synthetic(testing::experiment_with({}, 3));
  Dataset heavier = dataset;
  EXPECT_EQ(observe({dataset, dataset}).balls.size(), 1u);
  heavier.sphere.mass *= 1.1;
  const Observations two = observe({dataset, heavier});
  ASSERT_EQ(two.balls.size(), 2u);
  EXPECT_NE(two.balls[0].name, two.balls[1].name);
}

TEST(ObserveTest, AScalarWithoutUncertaintyIsNotUsedAndSaid) {
  Dataset dataset;
  dataset.name = "d";
  dataset.sphere = {.mass = 0.1, .diameter = 0.06};
  dataset.shots.push_back({.impact = {.speed = 5.0}, .restitution = {.value = 0.6}});
  const Observations seen = observe({dataset});
  EXPECT_TRUE(seen.shots.empty());
  EXPECT_FALSE(seen.warnings.empty());
}

}  // namespace
}  // namespace rebound
