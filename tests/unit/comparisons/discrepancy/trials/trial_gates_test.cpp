#include "comparisons/discrepancy/trials/trial_gates.hpp"

#include <gtest/gtest.h>

#include "tests/unit/comparisons/discrepancy/trials/trial_examples.hpp"

namespace rebound {
namespace {

using testing::gate;

TrialGate alarms(int count, int of) {
  TrialCounts counts;
  counts.false_alarm = {.count = count, .of = of};
  return gate(gates_of(counts), "false alarms on nulls");
}

TrialGate coverage(int count, int of) {
  TrialCounts counts;
  counts.coverage = {.count = count, .of = of};
  return gate(gates_of(counts), "size within its 95 % interval");
}

// Few trials with few alarms are no proof: 2 of 50 lie within the share that is allowed, and up to
// 13 % would not be strange.
TEST(TrialGatesTest, AGateAsksForItsUpperBoundToo) {
  EXPECT_FALSE(alarms(2, 50).passes());
  EXPECT_TRUE(alarms(20, 500).passes());
  EXPECT_FALSE(alarms(26, 500).passes());
}

// No count of 3 lies between 90 and 98 %; 19 of 20 does. Of 47 nulls without an alarm the upper
// bound is 7.6 %, of 48 it is 7.4 % (Wilson 1927).
TEST(TrialGatesTest, TooFewTrials) {
  EXPECT_EQ(coverage(3, 3).answer(), GateAnswer::too_few);
  EXPECT_EQ(coverage(20, 20).answer(), GateAnswer::missed);
  EXPECT_EQ(coverage(19, 20).answer(), GateAnswer::met);
  EXPECT_EQ(coverage(0, 0).answer(), GateAnswer::no_trial);
  EXPECT_EQ(alarms(0, 47).answer(), GateAnswer::too_few);
  EXPECT_EQ(alarms(0, 48).answer(), GateAnswer::met);
  EXPECT_EQ(gate(gates_of({}), "abstained from a family").answer(), GateAnswer::not_asked);
}

// What is plainly off is missed, however few they are.
TEST(TrialGatesTest, FewTrialsExcuseNoPlainMiss) {
  EXPECT_EQ(alarms(2, 29).answer(), GateAnswer::too_few);
  EXPECT_EQ(alarms(8, 29).answer(), GateAnswer::missed);
  EXPECT_EQ(coverage(0, 3).answer(), GateAnswer::missed);
}

}  // namespace
}  // namespace rebound
