#include "comparisons/discrepancy/diagnosis/data_checks/force_before_touch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "comparisons/io/dataset/contact_window.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

/// With the length of two contacts before the touch.
Dataset measured(std::int64_t seed) {
  SynthesisFile file = testing::experiment_with({}, seed);
  file.sampling.before = 6e-3;
  return testing::measured_data(file);
}

/// A pull on the plate that falls off over ten millimetres of gap; the contact is as without.
Dataset with_pull_at_a_distance(double pull, Dataset dataset) {
  constexpr double range = 10e-3;
  for (MeasuredImpact& shot : dataset.shots) {
    const std::vector<double> time = shot.trace.time, force = shot.trace.force;
    const double touched = 0.05 * *std::max_element(force.begin(), force.end());
    const SampleRange contact = contact_window(force, touched);
    for (std::size_t i = 0; i < time.size(); ++i) {
      const double before = std::max(0.0, time[contact.first] - time[i]);
      const double after = std::max(0.0, time[i] - time[contact.last]);
      shot.trace.force[i] -= pull * std::exp(-shot.impact.speed * (before + 0.7 * after) / range);
    }
  }
  return dataset;
}

// Four of two hundred are beyond 2.33 deviations on average, eleven or more once in five hundred.
TEST(ForceBeforeTouchTest, OfNoiseItIsWithinItsError) {
  int far = 0, above = 0;
  for (int seed = 0; seed < 200; ++seed) {
    const auto check = force_before_touch(measured(700 + seed));
    ASSERT_TRUE(check);
    far += std::abs(check->deviations()) > 2.326 ? 1 : 0;
    above += check->measured > 0.0 ? 1 : 0;
  }
  EXPECT_LE(far, 10);
  EXPECT_NEAR(above, 100, 22);  // three deviations
}

TEST(ForceBeforeTouchTest, SeesAPullAtADistance) {
  const auto check = force_before_touch(with_pull_at_a_distance(100.0, measured(1)));
  ASSERT_TRUE(check);
  EXPECT_LT(check->measured, -20.0);
  EXPECT_LT(check->deviations(), -5.0);
  EXPECT_EQ(check->what, before_touch);
}

TEST(ForceBeforeTouchTest, ARecordThatBeginsAtTheTouchHasNone) {
  Dataset dataset = measured(1);
  for (MeasuredImpact& shot : dataset.shots) {
    const double peak = *std::max_element(shot.trace.force.begin(), shot.trace.force.end());
    const auto first =
        static_cast<std::ptrdiff_t>(contact_window(shot.trace.force, 0.05 * peak).first);
    shot.trace.force.erase(shot.trace.force.begin(), shot.trace.force.begin() + first);
    shot.trace.time.erase(shot.trace.time.begin(), shot.trace.time.begin() + first);
  }
  EXPECT_FALSE(force_before_touch(dataset));
}

// What such a record lacks the diagnosis says; the check is no place to end.
TEST(ForceBeforeTouchTest, ARecordThatNeverReachesItsThresholdHasNone) {
  Dataset dataset = measured(1);
  for (MeasuredImpact& shot : dataset.shots) shot.contact_threshold = 1e9;
  EXPECT_FALSE(force_before_touch(dataset));
}

// Without the pull the same data agree.
TEST(ForceBeforeTouchTest, WhatActsAtADistanceIsUnexplained) {
  for (int seed = 1; seed <= 2; ++seed) {
    EXPECT_EQ(testing::diagnosis_of(measured(seed)).verdict, DiagnosisVerdict::agrees);
    const Diagnosis d = testing::diagnosis_of(with_pull_at_a_distance(60.0, measured(seed)));
    EXPECT_EQ(d.verdict, DiagnosisVerdict::unexplained);
    EXPECT_NE(d.withheld.find("before the first touch"), std::string::npos) << d.withheld;
  }
}

}  // namespace
}  // namespace rebound
