#include "comparisons/studies/reproduce/row.hpp"

#include <gtest/gtest.h>

namespace rebound {
namespace {

TEST(RowTest, VerdictsOfOnePublishedNumber) {
  const PrintedNumber published{2.42, 0.005};
  EXPECT_EQ(judge(published, 2.4207, {2.41, 2.43}), Verdict::reproduces);
  EXPECT_EQ(judge(published, 2.4300, {2.424, 2.436}), Verdict::within_rounding);
  EXPECT_EQ(judge(published, 2.4300, {2.426, 2.434}), Verdict::differs);
}

TEST(RowTest, TheEdgeOfHalfADigitCountsAsInside) {
  // 0.285 has no exact binary form; printed as 0.28 or 0.29, both are right.
  EXPECT_EQ(judge({0.28, 0.005}, 0.285, {0.285, 0.285}), Verdict::reproduces);
  EXPECT_EQ(judge({0.29, 0.005}, 0.285, {0.285, 0.285}), Verdict::reproduces);
}

TEST(RowTest, EvaluatesFromTheInputsAsPrinted) {
  const DerivedRow row{.key = {.table = "toy", .unit = "1"},
                       .published = {6.0, 0.05},
                       .inputs = {{"a", "all", {2.0, 0.05}}, {"b", "all", exactly(3.0)}},
                       .formula = [](const std::vector<double>& in) { return in[0] * in[1]; }};
  const Row result = evaluate(row);
  EXPECT_DOUBLE_EQ(result.computed, 6.0);
  EXPECT_DOUBLE_EQ(result.range.low, 5.85);
  EXPECT_DOUBLE_EQ(result.range.high, 6.15);
  EXPECT_EQ(result.verdict, Verdict::reproduces);
}

TEST(RowTest, NumbersAreWrittenWithThePaperDigits) {
  const Row time{.key = {.unit = "ms"}, .published = {2.42e-3, 0.005e-3}};
  EXPECT_EQ(as_printed(time, 2.4207e-3), "2.42");
  EXPECT_EQ(as_printed(time, 2.4207e-3, 1), "2.421");
  const Row stiffness{.key = {.unit = "1e5 N/m^1.5"}, .published = {17.0e5, 0.05e5}};
  EXPECT_EQ(as_printed(stiffness, 17.0e5), "17.0");
}

}  // namespace
}  // namespace rebound
