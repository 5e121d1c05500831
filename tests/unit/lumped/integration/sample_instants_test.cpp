#include "lumped/integration/sample_instants.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "lumped/integration/simulate.hpp"
#include "tests/support/lumped_cases.hpp"

namespace rebound {
namespace {

std::vector<double> instants(double contact_time, const LumpedControls& controls) {
  std::vector<double> time(sample_count(controls));
  fill_sample_instants(contact_time, controls, time);
  return time;
}

TEST(SampleInstantsTest, AreEvenWhereNothingElseIsAsked) {
  const auto time = instants(2e-3, {.samples = 201});
  ASSERT_EQ(time.size(), 201U);
  for (std::size_t i = 0; i < time.size(); ++i) EXPECT_NEAR(time[i], 1e-5 * double(i), 1e-17) << i;
  EXPECT_EQ(time.back(), 2e-3);
}

TEST(SampleInstantsTest, LieCloserAtBothEnds) {
  const auto time = instants(2e-3, {.samples = 201, .finer_ends = true});
  ASSERT_EQ(time.size(), 241U);
  EXPECT_EQ(time.front(), 0.0);
  EXPECT_EQ(time.back(), 2e-3);
  for (std::size_t i = 1; i < time.size(); ++i) {
    EXPECT_GT(time[i], time[i - 1]) << i;
    EXPECT_LE(time[i] - time[i - 1], 1.0001e-5) << i;
    EXPECT_NEAR(time[i] + time[time.size() - 1 - i], 2e-3, 1e-17) << i;  // the same at both ends
  }
  EXPECT_LT(time[1], 1e-8);
  EXPECT_NEAR(time[24], 4e-5, 1e-17);
  EXPECT_NEAR(time[25], 5e-5, 1e-17);
}

// A bare law by either integrator, and a composed contact: all three samplers.
TEST(SampleInstantsTest, AreThoseOfEveryIntegrator) {
  LumpedProblem problem = test::typical_problem("tsuji");
  problem.controls.finer_ends = true;
  LumpedProblem composed = problem;
  composed.model.mechanisms.memory.permanent_set = 0.05;
  for (const LumpedProblem& one : {problem, composed}) {
    const LumpedResult fast = simulate_fast(one), reference = simulate(one);
    ASSERT_EQ(fast.trace.time.size(), sample_count(one.controls));
    ASSERT_EQ(reference.trace.time.size(), sample_count(one.controls));
    const auto expected = instants(fast.scalars.contact_time, one.controls);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_NEAR(fast.trace.time[i], expected[i], 1e-12) << i;
      EXPECT_NEAR(fast.trace.force[i], reference.trace.force[i], 1e-5 * fast.scalars.peak_force)
          << i;
    }
  }
}

}  // namespace
}  // namespace rebound
