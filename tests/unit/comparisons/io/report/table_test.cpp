#include "comparisons/io/report/table.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "lumped/problem/error.hpp"

namespace rebound::report {
namespace {

TEST(NumberCell, KeepsSignificantDigits) {
  EXPECT_EQ(number_cell(0.52731, 3).text, "0.527");
  EXPECT_EQ(number_cell(0.5, 3).text, "0.500");
  EXPECT_EQ(number_cell(530.0, 3).text, "530");
  EXPECT_EQ(number_cell(-1.996, 3).text, "-2.00");
  EXPECT_EQ(number_cell(0.0, 2).text, "0.0");
  EXPECT_EQ(number_cell(9.996, 3).text, "10.0");
  EXPECT_EQ(number_cell(11369.86, 3).text, "11370");
  EXPECT_EQ(number_cell(2.5e7, 2).text, "2.5e+07");
}

TEST(UncertainCell, TwoDigitsOfTheHalfWidthDecide) {
  EXPECT_EQ(uncertain_cell(0.52731, 0.0123).text, "0.527 ± 0.012");
  EXPECT_EQ(uncertain_cell(5.2, 0.31).text, "5.20 ± 0.31");
  EXPECT_EQ(uncertain_cell(4053.2, 123.0).text, "4053 ± 123");
  EXPECT_EQ(uncertain_cell(0.0, 0.4).text, "0.00 ± 0.40");
}

TEST(UncertainCell, LargeAndSmallNumbersShareAPowerOfTen) {
  EXPECT_EQ(uncertain_cell(3.5e6, 2.0e5).text, "(3.50 ± 0.20)e6");
  EXPECT_EQ(uncertain_cell(4.2e-6, 1.1e-7).text, "(4.20 ± 0.11)e-6");
  EXPECT_EQ(uncertain_cell(2.0e-7, 3.0e-6).text, "(0.2 ± 3.0)e-6");
}

TEST(Cells, RefuseWhatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(number_cell(nan, 3), Error);
  EXPECT_THROW(number_cell(1.0, 0), Error);
  EXPECT_THROW(uncertain_cell(nan, 0.1), Error);
  EXPECT_THROW(uncertain_cell(1.0, std::numeric_limits<double>::infinity()), Error);
  EXPECT_THROW(uncertain_cell(1.0, 0.0), Error);
}

}  // namespace
}  // namespace rebound::report
