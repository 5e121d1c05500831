#include "comparisons/models/instrument/contact_ends.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "comparisons/models/instrument/reported_force.hpp"

namespace rebound {
namespace {

constexpr double duration = 2e-3;

/// A force that begins and ends with half powers of time, and is not the same at both ends.
double pulse(double t) {
  const double s = t / duration;
  return std::pow(s, 1.5) * std::pow(1.0 - s, 1.5) * (1.0 + s);
}

Trace sampled(int samples, double (*force)(double)) {
  Trace trace;
  for (int i = 0; i < samples; ++i) {
    trace.time.push_back(duration * i / (samples - 1));
    trace.force.push_back(force(trace.time.back()));
    trace.deflection.push_back(trace.time.back());
  }
  return trace;
}

TEST(ContactEndsTest, HalfPowersAreExact) {
  for (const auto force :
       {+[](double t) { return std::pow(t, 1.5); }, +[](double t) { return std::pow(t, 2.5); },
        +[](double t) { return std::pow(duration - t, 1.5); }}) {
    const Trace finer = with_finer_ends(sampled(201, force));
    const double peak = std::pow(duration, 1.5);
    const bool rises = finer.force.back() >= finer.force.front();
    const std::size_t own = finer.time.size() / 2;  // the end at which the power stands
    for (std::size_t i = rises ? 0 : own; i < (rises ? own : finer.time.size()); ++i)
      EXPECT_NEAR(finer.force[i], force(finer.time[i]), 1e-13 * peak) << i;
  }
}

TEST(ContactEndsTest, TimeIncreasesAndAllColumnsFollow) {
  const Trace finer = with_finer_ends(sampled(201, pulse));
  ASSERT_EQ(finer.force.size(), finer.time.size());
  ASSERT_EQ(finer.deflection.size(), finer.time.size());
  for (std::size_t i = 1; i < finer.time.size(); ++i)
    EXPECT_GT(finer.time[i], finer.time[i - 1]) << i;
  for (std::size_t i = 0; i < finer.time.size(); ++i)
    EXPECT_NEAR(finer.deflection[i], finer.time[i], 1e-12 * duration) << i;
  EXPECT_EQ(finer.time.front(), 0.0);
  EXPECT_EQ(finer.time.back(), duration);
}

TEST(ContactEndsTest, FewSamplesStayAsTheyAre) {
  EXPECT_EQ(with_finer_ends(sampled(11, pulse)).time.size(), 11U);
}

/// Largest error between samples over the peak.
double worst_error(const Trace& trace) {
  std::vector<double> time;
  for (int i = 0; i <= 9001; ++i) time.push_back(duration * i / 9001.0);
  const std::vector<double> read = reported_force(trace, {}, time);
  double worst = 0.0;
  for (std::size_t i = 0; i < time.size(); ++i)
    worst = std::max(worst, std::abs(read[i] - pulse(time[i])));
  return worst / pulse(0.55 * duration);
}

// Cubic between 201 equal samples: the onset decides. What is left with finer ends is the body.
TEST(ContactEndsTest, TheCubicBetweenSamplesMissesTheOnsetNoMore) {
  EXPECT_GT(worst_error(sampled(201, pulse)), 5e-5);
  EXPECT_LT(worst_error(with_finer_ends(sampled(201, pulse))), 3e-6);
}

}  // namespace
}  // namespace rebound
