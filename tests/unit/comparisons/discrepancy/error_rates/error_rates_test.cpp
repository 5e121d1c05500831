// What blind trials say of a verdict.
#include "comparisons/discrepancy/error_rates/error_rates.hpp"

#include <gtest/gtest.h>

#include "tests/unit/comparisons/discrepancy/trials/trial_examples.hpp"

namespace rebound {
namespace {

using testing::hidden;
using testing::nothing_hidden;
using testing::said;

TrialRecord trial(TrialTruth truth, TrialOutcome outcome, double noise, int speeds) {
  truth.noise_share = noise;
  outcome.speeds = speeds;
  return {.truth = std::move(truth), .outcome = std::move(outcome)};
}

/// Was a verdict true of this truth?
bool counts_as_true(const TrialTruth& truth, const TrialOutcome& outcome) {
  const auto rates = error_rates_of({.speeds = 3, .noise_share = 0.01}, outcome.said.verdict,
                                    {trial(truth, outcome, 0.01, 3)});
  EXPECT_EQ(rates.front().verdict_true.of, 1);
  return rates.front().verdict_true.count == 1;
}

// Counted in the table by another program: noise 0.03, two or three speeds.
TEST(ErrorRatesTest, CountsAreThoseOfTheStoredTrials) {
  const auto rates = error_rates_of({.speeds = 3, .noise_share = 0.028}, "missing");
  ASSERT_EQ(rates.size(), 2u);
  EXPECT_EQ(rates[0].trials, 82);
  EXPECT_EQ(rates[0].noise_share, 0.03);
  EXPECT_EQ(rates[0].fewest_speeds, 2);
  EXPECT_EQ(rates[0].most_speeds, 3);
  EXPECT_EQ(rates[0].false_alarm.count, 0);
  EXPECT_EQ(rates[0].false_alarm.of, 21);
  EXPECT_EQ(rates[0].verdict_true.count, 11);
  EXPECT_EQ(rates[0].verdict_true.of, 13);
  EXPECT_TRUE(rates[1].in_fem);
  EXPECT_EQ(rates[1].trials, 40);
  EXPECT_EQ(rates[1].false_alarm.count, 0);
  EXPECT_EQ(rates[1].false_alarm.of, 22);
}

TEST(ErrorRatesTest, TheNearestNoiseIsThatOfTheNearestRatio) {
  const std::vector<TrialRecord> trials{trial(nothing_hidden(1), said(1, "agrees"), 0.01, 3),
                                        trial(nothing_hidden(2), said(2, "agrees"), 0.05, 3)};
  EXPECT_EQ(error_rates_of({.speeds = 2, .noise_share = 0.02}, "agrees", trials)[0].noise_share,
            0.01);
  EXPECT_EQ(error_rates_of({.speeds = 2, .noise_share = 0.03}, "agrees", trials)[0].noise_share,
            0.05);
}

TEST(ErrorRatesTest, TrialsWithManySpeedsSayNothingOfThree) {
  const std::vector<TrialRecord> trials{trial(nothing_hidden(1), said(1, "agrees"), 0.01, 4),
                                        trial(nothing_hidden(2), said(2, "missing"), 0.01, 7)};
  EXPECT_TRUE(error_rates_of({.speeds = 3, .noise_share = 0.01}, "agrees", trials).empty());
  const auto rates = error_rates_of({.speeds = 5, .noise_share = 0.01}, "agrees", trials);
  ASSERT_EQ(rates.size(), 1u);
  EXPECT_EQ(rates[0].fewest_speeds, 4);
  EXPECT_EQ(rates[0].most_speeds, 7);
  EXPECT_EQ(rates[0].false_alarm.count, 1);
  EXPECT_EQ(rates[0].false_alarm.of, 2);
}

TEST(ErrorRatesTest, WithoutRecordsOfForceNoTrialIsAlike) {
  EXPECT_TRUE(error_rates_of({.speeds = 3, .noise_share = 0.0}, "missing").empty());
}

TEST(ErrorRatesTest, AVerdictIsTrueWhereItSaysWhatWasHidden) {
  const TrialTruth relaxation = hidden(1, "memory", "relaxation", 400.0);
  TrialTruth two = relaxation;
  two.effects.push_back(hidden(1, "measurement", "sensor-lag").effects.front());
  const auto one_of = [](const std::string& first, const std::string& second) {
    TrialOutcome set = said(1, "one-of");
    set.said.candidates = {{first}, {second}};
    return set;
  };
  const auto both = [](const std::string& first, const std::string& second) {
    TrialOutcome pair = said(1, "missing");
    pair.said.candidates = {{first, second}};
    return pair;
  };
  const struct {
    TrialTruth truth;
    TrialOutcome outcome;
    bool is_true;
  } cases[] = {
      {relaxation, said(1, "missing", "memory", "relaxation"), true},
      {relaxation, said(1, "missing", "rate", "linear-dashpot"), false},
      {relaxation, said(1, "family", "memory"), true},
      {relaxation, said(1, "family", "rate"), false},
      {relaxation, said(1, "agrees"), false},
      {relaxation, said(1, "measurement-fault"), false},
      {relaxation, said(1, "unexplained"), true},
      {relaxation, one_of("linear-dashpot", "relaxation"), true},
      {relaxation, one_of("linear-dashpot", "adhesion"), false},
      {relaxation, both("relaxation", "sensor-lag"), false},
      {two, both("relaxation", "sensor-lag"), true},
      {two, both("relaxation", "adhesion"), false},
      {hidden(1, "measurement", "hum", 400.0), said(1, "measurement-fault"), true},
  };
  for (std::size_t i = 0; i < std::size(cases); ++i)
    EXPECT_EQ(counts_as_true(cases[i].truth, cases[i].outcome), cases[i].is_true) << "case " << i;
}

// What cannot be seen is not missed.
TEST(ErrorRatesTest, OfAnEffectThatDoesNotShowAgreementIsTrue) {
  EXPECT_TRUE(counts_as_true(hidden(1, "memory", "relaxation", 24.0), said(1, "agrees")));
  EXPECT_FALSE(counts_as_true(hidden(1, "memory", "relaxation", 26.0), said(1, "agrees")));
}

}  // namespace
}  // namespace rebound
