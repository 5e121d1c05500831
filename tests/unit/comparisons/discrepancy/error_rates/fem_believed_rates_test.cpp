// Trials in which a believed FE model was asked say nothing of a lumped one.
#include <gtest/gtest.h>

#include "comparisons/discrepancy/error_rates/error_rates.hpp"
#include "tests/unit/comparisons/discrepancy/trials/trial_examples.hpp"

namespace rebound {
namespace {

TEST(FemBelievedRatesTest, AreNoRatesOfALumpedBelief) {
  TrialTruth asked = testing::nothing_hidden(1), doubted = testing::nothing_hidden(2);
  asked.ball = doubted.ball = "foam";
  asked.noise_share = doubted.noise_share = 0.01;
  doubted.believed = "fem";
  const auto rates = error_rates_of({.speeds = 3, .noise_share = 0.01}, "agrees",
                                    {{.truth = asked, .outcome = testing::said(1, "agrees")},
                                     {.truth = doubted, .outcome = testing::said(2, "one-of")}});
  ASSERT_EQ(rates.size(), 1u);
  EXPECT_TRUE(rates[0].in_fem);
  EXPECT_EQ(rates[0].false_alarm.of, 1);
  EXPECT_EQ(rates[0].false_alarm.count, 0);
}

}  // namespace
}  // namespace rebound
