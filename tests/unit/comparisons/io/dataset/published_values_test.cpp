#include "comparisons/io/dataset/published_values.hpp"

#include <gtest/gtest.h>

#include "tests/support/refusals.hpp"

namespace rebound {
namespace {

TEST(PrintedNumberTest, HalfAUnitOfTheLastDigit) {
  const Document document = Document::parse(R"(a = 0.640
b = "3.50e6 N/m^1.5"
c = "2.09 ms"
d = 4
e = "11.7 MPa"
)",
                                            "f");
  EXPECT_DOUBLE_EQ(printed_number(document, "a").half_width, 0.0005);
  EXPECT_DOUBLE_EQ(printed_number(document, "b").half_width, 0.005e6);
  EXPECT_DOUBLE_EQ(printed_number(document, "c").half_width, 0.005e-3);
  EXPECT_DOUBLE_EQ(printed_number(document, "d").half_width, 0.5);
  EXPECT_DOUBLE_EQ(printed_number(document, "e").half_width, 0.05e6);
  EXPECT_EQ(printed_number(document, "c").value, 2.09e-3);
  EXPECT_EQ(testing::refusal_of([&] { printed_number(document, "x"); }).location().key, "x");
}

}  // namespace
}  // namespace rebound
