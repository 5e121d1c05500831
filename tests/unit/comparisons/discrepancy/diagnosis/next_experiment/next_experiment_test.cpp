// Which measurement is said to tell candidates apart, against what happens when it is made.
#include <gtest/gtest.h>

#include <algorithm>

#include "comparisons/discrepancy/diagnosis/next_experiment/next_experiment.hpp"
#include "comparisons/discrepancy/diagnosis/observations/observe.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound::testing {
namespace {

const EffectChoice exponent{.name = "force-exponent", .size = 0.06};
const EffectChoice stiffening{.name = "strain-stiffening", .size = 0.5};

SynthesisFile experiment_at(const std::vector<double>& speeds, std::int64_t seed) {
  SynthesisFile file = experiment_with({exponent}, seed);
  file.shots.clear();
  for (const double speed : speeds)
    file.shots.push_back({.speed = speed, .speed_uncertainty = 0.003 * speed});
  return file;
}

Observations observed(const SynthesisFile& file) {
  return observe({synthesize(file, simulator_of(file, {})).dataset});
}

HypothesisFit fit_of(const Observations& seen, const EffectChoice& effect) {
  return fit_hypothesis(seen, {.believed = believed_law(), .effects = {effect}});
}

PlannedExperiment history_at_times(double factor) {
  return {.what = "force history", .records = {{.speed_factor = factor}}};
}

TEST(NextExperimentTest, ARivalThatIsFittedAgainComesNearer) {
  const Observations seen = observed(experiment_at({5.0, 8.0}, 1));
  const HypothesisFit truth = fit_of(seen, exponent), rival = fit_of(seen, stiffening);
  const HeldFit a = held_by_the_data(truth), b = held_by_the_data(rival);
  HeldFit firm = b;  // as if the data at hand held every number
  firm.stiffness *= 1e6;
  const PlannedExperiment fast = history_at_times(3.0);
  const double again = expected_separation(seen, a, b, fast);
  EXPECT_GT(again, 1.0);
  EXPECT_LT(again, 0.5 * expected_separation(seen, a, firm, fast));
  EXPECT_NEAR(expected_separation(seen, a, a, fast), 0.0, 1e-9);
}

TEST(NextExperimentTest, RepeatsCountAsOften) {
  const Observations seen = observed(experiment_at({5.0, 8.0}, 1));
  const HypothesisFit truth = fit_of(seen, exponent), rival = fit_of(seen, stiffening);
  HeldFit a = held_by_the_data(truth), b = held_by_the_data(rival);
  b.stiffness *= 1e6;
  PlannedExperiment once = history_at_times(3.0), four = once;
  four.repeats = 4;
  const double single = expected_separation(seen, a, b, once);
  EXPECT_NEAR(expected_separation(seen, a, b, four), 4.0 * single, 1e-3 * single);
}

/// Mean predicted chance, and the share of experiments after which the rival was out.
struct Chances {
  double predicted = 0.0, seen = 0.0;
};

Chances chances_of(double factor) {
  constexpr int experiments = 30;
  constexpr double close = 6.0, slowest = 5.0;
  Chances chances;
  for (int seed = 1; seed <= experiments; ++seed) {
    const Observations first = observed(experiment_at({slowest, 8.0}, seed));
    const HypothesisFit truth = fit_of(first, exponent), rival = fit_of(first, stiffening);
    chances.predicted +=
        chance_that_truth_wins(first, held_by_the_data(truth), held_by_the_data(rival),
                               history_at_times(factor), close) /
        experiments;
    const Observations both = observed(experiment_at({slowest, 8.0, factor * slowest}, seed));
    if (fit_of(both, stiffening).information_criterion >
        fit_of(both, exponent).information_criterion + close)
      chances.seen += 1.0 / experiments;
  }
  return chances;
}

TEST(NextExperimentTest, ThePredictedChanceIsTheShareThatIsSeen) {
  for (const double factor : {3.0, 4.0, 6.0}) {
    const Chances chances = chances_of(factor);
    RecordProperty("times_" + std::to_string(static_cast<int>(factor)),
                   std::to_string(chances.predicted) + " " + std::to_string(chances.seen));
    EXPECT_NEAR(chances.predicted, chances.seen, 0.15) << factor;
    if (factor < 6.0) {
      EXPECT_LT(chances.predicted, 0.5) << factor;  // held at its numbers the rival would be out
    } else {
      EXPECT_GT(chances.predicted, 0.6) << factor;
    }
  }
}

// The rival is out once it is behind by the close criterion: what the truth leads by already
// counts.
TEST(NextExperimentTest, ALeadInHandRaisesTheChance) {
  const Observations seen = observed(experiment_at({5.0, 8.0}, 1));
  HypothesisFit truth = fit_of(seen, exponent);
  const HypothesisFit rival = fit_of(seen, stiffening);
  const auto chance_with_lead = [&](double lead, double close) {
    truth.information_criterion = rival.information_criterion - lead;
    return chance_that_truth_wins(seen, held_by_the_data(truth), held_by_the_data(rival),
                                  history_at_times(3.0), close);
  };
  EXPECT_LT(chance_with_lead(-3.0, 6.0), chance_with_lead(0.0, 6.0));
  EXPECT_LT(chance_with_lead(0.0, 6.0), chance_with_lead(3.0, 6.0));
  // A lead and a criterion that is as much lower are the same.
  EXPECT_NEAR(chance_with_lead(4.0, 6.0), chance_with_lead(0.0, 2.0), 1e-9);
}

TEST(NextExperimentTest, WhatIsThereIsNotProposed) {
  Observations seen = observed(experiment_at({5.0, 8.0}, 1));
  const auto says = [&](const std::string& word) {
    const auto all = possible_experiments(seen);
    return std::any_of(all.begin(), all.end(), [&](const PlannedExperiment& one) {
      return one.what.find(word) != std::string::npos;
    });
  };
  EXPECT_TRUE(says("slow compression"));
  EXPECT_TRUE(says("deflection over time"));
  EXPECT_TRUE(says("4 further hits"));
  seen.compressions.emplace_back();
  for (MeasuredImpact& shot : seen.shots) shot.deflection_noise.deviation = 1e-5;
  EXPECT_FALSE(says("slow compression"));
  EXPECT_FALSE(says("deflection over time"));
  for (MeasuredImpact& shot : seen.shots) shot.trace = {};
  EXPECT_FALSE(says("further hits"));
  EXPECT_TRUE(says("force history at 5 m/s"));
}

}  // namespace
}  // namespace rebound::testing
