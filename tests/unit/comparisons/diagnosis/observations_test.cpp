#include "comparisons/diagnosis/observations.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>
#include <string>

#include "tests/unit/comparisons/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

Dataset synthetic(const SynthesisFile& file) {
  return synthesize(file, simulator_of(file, {})).dataset;
}

TEST(ObservationsTest, SharedErrorBoundsABlock) {
  ForceHistory history{.time = {}, .force = std::vector<double>(40, 0.0), .noise = 2.0};
  const std::vector<double> model(40, 1.0);
  for (const double r : whitened(history, model)) EXPECT_EQ(r, 0.5);
  history.shared_error = 1.0;
  history.shared_by = 20;
  // A constant misfit of 1 over a block that is known to 1: about one standard deviation.
  const auto r = whitened(history, model);
  const double chi_square = std::inner_product(r.begin(), r.begin() + 20, r.begin(), 0.0);
  EXPECT_NEAR(chi_square, 1.0 / (1.0 + 4.0 / 20.0), 1e-12);
}

TEST(ObservationsTest, NoiseIsTakenFromBeforeContactWhereNoneIsStated) {
  SynthesisFile file = testing::experiment_with({}, 3);
  Dataset dataset = synthetic(file);
  dataset.instrument.force_noise.reset();
  const Observations seen = observe({dataset});
  ASSERT_TRUE(seen.shots[0].history.has_value());
  EXPECT_NEAR(seen.shots[0].history->noise, 20.0, 7.5);  // three standard errors of 30 samples
  EXPECT_NE(seen.noise_from.find("before contact"), std::string::npos);
}

TEST(ObservationsTest, WithoutAnyNoiseItSaysWhatIsMissing) {
  SynthesisFile file = testing::experiment_with({}, 3);
  file.sampling.before = 0.0;
  Dataset dataset = synthetic(file);
  dataset.instrument.force_noise.reset();
  EXPECT_FALSE(observe({dataset}).missing.empty());
}

TEST(ObservationsTest, FastSamplingIsAveragedWithItsNoise) {
  SynthesisFile file = testing::experiment_with({}, 3);
  file.sampling.rate = 2e6;
  const Observations seen = observe({synthetic(file)});
  EXPECT_LT(seen.shots[0].history->time.size(), 1500u);
  EXPECT_LT(seen.shots[0].history->noise, 10.0);
}

TEST(ObservationsTest, RepeatsHaveNamesOfTheirOwn) {
  SynthesisFile file = testing::experiment_with({}, 3);
  file.shots.push_back(file.shots.front());
  const Dataset dataset = synthetic(file);
  const Observations seen = observe({dataset, dataset});
  std::set<std::string> labels;
  for (const ObservedShot& shot : seen.shots) labels.insert(shot.label);
  EXPECT_EQ(labels.size(), 8u);
}

TEST(ObservationsTest, OneBallInTwoDataSetsIsOne) {
  const Dataset dataset = synthetic(testing::experiment_with({}, 3));
  Dataset heavier = dataset;
  EXPECT_EQ(observe({dataset, dataset}).balls.size(), 1u);
  heavier.sphere.mass *= 1.1;
  const Observations two = observe({dataset, heavier});
  ASSERT_EQ(two.balls.size(), 2u);
  EXPECT_NE(two.balls[0].name, two.balls[1].name);
}

TEST(ObservationsTest, AScalarWithoutUncertaintyIsNotUsedAndSaid) {
  Dataset dataset;
  dataset.name = "d";
  dataset.sphere = {.mass = 0.1, .diameter = 0.06};
  dataset.shots.push_back({.speed = 5.0, .restitution = {.value = 0.6}});
  const Observations seen = observe({dataset});
  EXPECT_TRUE(seen.shots.empty());
  EXPECT_FALSE(seen.warnings.empty());
}

}  // namespace
}  // namespace rebound
