// What a plan predicts, against what diagnoses of its experiments say.
#include "comparisons/discrepancy/design/planned_experiments.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "comparisons/models/parallel/in_parallel.hpp"
#include "lumped/problem/error.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

// Over the three sizes together, within 0.1 and two standard deviations of so few experiments.
TEST(PlannedExperimentsTest, WhatIsPredictedIsCounted) {
  const SynthesisFile plan = testing::coarse_experiment(5);
  const TestDesign design = design_test(plan, 1);
  const auto rows = count_chances(plan, design, {.experiments = 8, .effect = "relaxation"});
  ASSERT_EQ(rows.size(), 1 + design_chances.size());
  EXPECT_LE(rows.front().gap.count, 2);
  double predicted = 0.0, named = 0.0, variance = 0.0;
  int gaps = 0, names = 0, all = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double n = rows[i].gap.of, p = rows[i].predicted.gap;
    predicted += n * p;
    named += n * rows[i].predicted.named;
    variance += n * p * (1.0 - p);
    gaps += rows[i].gap.count;
    names += rows[i].named.count;
    all += rows[i].gap.of;
  }
  const double slack = 0.1 * all + 2.0 * std::sqrt(variance);
  RecordProperty("gaps", gaps);
  EXPECT_NEAR(gaps, predicted, slack);
  EXPECT_NEAR(names, named, slack);
}

TEST(PlannedExperimentsTest, ThreadsChangeNothing) {
  const SynthesisFile plan = testing::coarse_experiment(5);
  TestDesign design;
  FindableEffect& effect = design.effects.emplace_back(FindableEffect{.name = "relaxation"});
  effect.sizes = {{.hidden = {"relaxation", 0.5}, .size = 0.5}};
  const auto count = [&](int threads) {
    const ThreadLimit limit(threads);
    return count_chances(plan, design, {.experiments = 2});
  };
  const auto one = count(1), two = count(2);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].gap.count, two[i].gap.count);
    EXPECT_EQ(one[i].named.count, two[i].named.count);
  }
  EXPECT_EQ(one.back().gap.count, 2);  // ten times what shows
}

TEST(PlannedExperimentsTest, RefusesWhatIsNotFoundAndEndsWhenAsked) {
  EXPECT_THROW(
      count_chances(testing::coarse_experiment(5), {}, {.experiments = 1, .effect = "relaxation"}),
      Error);
  const RunControl stop{.interrupted = [] { return true; }, .progress = {}};
  try {
    count_chances(testing::coarse_experiment(5), {}, {.experiments = 1}, stop);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::interrupted);
  }
}

}  // namespace
}  // namespace rebound
