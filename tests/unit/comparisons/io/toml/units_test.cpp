#include "comparisons/io/toml/units.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr Dimension hertz_stiffness{1.0, -0.5, -2.0};  // N/m^1.5
constexpr Dimension hertz_damping{1.0, -1.5, -1.0};    // N s/m^2.5

TEST(UnitsTest, ReadsEveryUnitOfTheContract) {
  EXPECT_EQ(parse_quantity("15 m/s", dimension::speed), 15.0);
  EXPECT_EQ(parse_quantity("33.1 mm", dimension::length), 0.0331);
  EXPECT_EQ(parse_quantity("2.5 MPa", dimension::pressure), 2.5e6);
  EXPECT_EQ(parse_quantity("0.3 ms", dimension::time), 0.3e-3);
  EXPECT_EQ(parse_quantity("89.6 g", dimension::mass), 0.0896);
  EXPECT_EQ(parse_quantity("3.5e6 N/m^1.5", hertz_stiffness), 3.5e6);
  EXPECT_EQ(parse_quantity("17.63e4 N.s/m^2.5", hertz_damping), 17.63e4);
  EXPECT_EQ(parse_quantity("10 um/s", dimension::speed), 10e-6);
  EXPECT_EQ(parse_quantity("20 kHz", dimension::frequency), 20e3);
  EXPECT_EQ(parse_quantity("50 MN/m", dimension::energy_per_area), 50e6);
}

TEST(UnitsTest, PrefixAndExponentGiveTheSameBits) {
  for (const char* text :
       {"66.2 mm", "66200 um", "0.0662 m", "6.62e-2 m", "0.0000662 km", "6.62 cm"})
    EXPECT_EQ(parse_quantity(text, dimension::length), 0.0662) << text;
}

TEST(UnitsTest, BothMicroSignsAreRead) {
  EXPECT_EQ(parse_quantity("1 \u00b5s", dimension::time), 1e-6);
  EXPECT_EQ(parse_quantity("1 \u03bcs", dimension::time), 1e-6);
}

TEST(UnitsTest, FractionalPowerOfAPrefixedUnit) {
  // 1 N/mm^1.5 = 10^4.5 N/m^1.5
  EXPECT_NEAR(parse_quantity("1 N/mm^1.5", hertz_stiffness), std::pow(10.0, 4.5), 1e-10);
}

TEST(UnitsTest, EveryProductAfterABarDivides) {
  EXPECT_EQ(parse_unit("kg/m/s^2").dimension, dimension::pressure);
  EXPECT_EQ(parse_unit("N.s/m").dimension, (Dimension{1, 0, -1}));
  EXPECT_EQ(parse_unit("1/s").dimension, dimension::frequency);
  EXPECT_EQ(parse_unit("N.m^0.5").dimension, (Dimension{1, 1.5, -2}));
}

TEST(UnitsTest, RefusesWhatIsNoQuantity) {
  for (const char* text :
       {"15", "", "m", "15 furlong", "15 m/", "15m/s", "1,5 m/s", "nan m/s", "inf m/s", "1e400 m/s",
        "15 m", "15 m^/s", "0x10 m/s", "15 pm/s", "--1 m/s", "1 m//s", "1e300 Gm/ns"})
    EXPECT_THROW(parse_quantity(text, dimension::speed), Error) << text;
}

TEST(UnitsTest, WrittenTextReadsBackToTheSameBits) {
  for (const double value : {0.0662, 0.0896, 1.0 / 3.0, 1e-9, 0.00191, 0.1 + 0.2, 5e-324}) {
    EXPECT_EQ(parse_quantity(format_quantity(value, "mm"), dimension::length), value);
    EXPECT_EQ(parse_quantity(format_quantity(value, "us"), dimension::time), value);
  }
  EXPECT_EQ(format_quantity(0.0662, "mm"), "66.2 mm");
}

TEST(UnitsTest, NamesOfDimensionsReadBack) {
  for (const Dimension d : {hertz_stiffness, hertz_damping, dimension::pressure, dimension::speed,
                            dimension::mass, Dimension{0, -0.5, 0}, Dimension{1, 0, -2}}) {
    const Dimension read = parse_unit(unit_name(d)).dimension;
    EXPECT_NEAR(read.kilogram, d.kilogram, 1e-9) << unit_name(d);
    EXPECT_NEAR(read.metre, d.metre, 1e-9) << unit_name(d);
    EXPECT_NEAR(read.second, d.second, 1e-9) << unit_name(d);
  }
  EXPECT_EQ(unit_name(hertz_stiffness), "N/m^1.5");
  EXPECT_EQ(unit_name(dimension::energy_per_area), "N/m");  // a stiffness, as laws have it
  EXPECT_EQ(unit_name(hertz_damping), "N.s/m^2.5");
}

}  // namespace
}  // namespace rebound
