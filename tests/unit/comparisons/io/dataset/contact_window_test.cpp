#include "comparisons/io/dataset/contact_window.hpp"

#include <gtest/gtest.h>

#include "comparisons/io/dataset/dataset.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

TEST(ContactWindowTest, ThresholdIsStatedOrThreeSigmaOrZero) {
  Dataset dataset;
  const auto threshold = [&] { return contact_threshold(completed(dataset, {})); };
  EXPECT_EQ(threshold(), 0.0);
  dataset.instrument.force_noise = 5.0;
  EXPECT_EQ(threshold(), 15.0);
  dataset.instrument.contact_threshold = 8.0;
  EXPECT_EQ(threshold(), 8.0);
  dataset.instrument.contact_threshold = 0.0;  // stated: the noise is not asked
  EXPECT_EQ(threshold(), 0.0);
}

TEST(ContactWindowTest, GoesFromTheFirstToTheLastForceAbove) {
  const std::vector<double> force{0, 2, 5, 1, 7, 2, 0};  // a dip belongs to the contact
  const SampleRange range = contact_window(force, 2.0);
  EXPECT_EQ(range.first, 2u);
  EXPECT_EQ(range.last, 4u);
  EXPECT_EQ(range.count(), 3u);
  EXPECT_THROW(contact_window(force, 7.0), Error);
}

TEST(ContactWindowTest, IsWidenedAsFarAsTheRecordGoes) {
  const SampleRange one = widened({2, 4}, 1, 7), all = widened({2, 4}, 10, 7);
  EXPECT_EQ(one.first, 1u);
  EXPECT_EQ(one.last, 5u);
  EXPECT_EQ(all.first, 0u);
  EXPECT_EQ(all.last, 6u);
}

TEST(ContactWindowTest, CutsWithTimeFromZeroAndKeepsTheDeflectionIfAny) {
  Trace trace{.time = {5, 6, 7, 8}, .force = {0, 1, 2, 0}, .deflection = {}, .further = {}};
  EXPECT_EQ(cut(trace, {1, 2}).time, (std::vector<double>{0, 1}));
  EXPECT_TRUE(cut(trace, {1, 2}).deflection.empty());
  trace.deflection = {0, 3, 4, 5};
  EXPECT_EQ(cut(trace, {1, 2}).deflection, (std::vector<double>{3, 4}));
  EXPECT_EQ(cut_at(trace, 7.0).force, (std::vector<double>{0, 1, 2}));
}

// A solver's record goes on after separation: its length is no contact time.
TEST(ContactWindowTest, WithoutThresholdTheSeparationRuleTellsTheContactTime) {
  const Trace trace{
      .time = {0, 1, 2, 3, 4}, .force = {0, 10, 0, 0, 0}, .deflection = {}, .further = {}};
  EXPECT_EQ(reported_contact_time(trace, 2.0, 0.0), 2.0);
  EXPECT_DOUBLE_EQ(reported_contact_time(trace, 2.0, 5.0), 1.0);
}

}  // namespace
}  // namespace rebound
