#include "fem/kernel/simd.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/fem_cases.hpp"

namespace rebound::fem {
namespace {

using Real = VectorOf<2>::Real;

/// Distance from the exact value in units in the last place of it.
double units_off(double found, long double exact) {
  const double rounded = std::abs(static_cast<double>(exact));
  const double unit = std::nextafter(rounded, std::numeric_limits<double>::infinity()) - rounded;
  return static_cast<double>(std::abs(found - exact) / unit);
}

TEST(SimdMath, LogAgainstLibrary) {
  test::Random random(1);
  for (int i = 0; i < 200000; ++i) {
    // Every third near 1, where ln x loses its leading digits.
    const double x = i % 3 == 0 ? 1.0 + 0.01 * random() : std::exp(700.0 * random());
    const Real found = log(Real{x, 1.0 / x});
    for (const auto& [got, at] : {std::pair(found[0], x), std::pair(found[1], 1.0 / x)}) {
      const long double exact = std::log(static_cast<long double>(at));
      if (std::abs(got - exact) > 1e-16L) {
        ASSERT_LT(units_off(got, exact), 3.0) << at;
      }
    }
  }
  EXPECT_EQ(log(Real{1.0, 1.0})[0], 0.0);
}

TEST(SimdMath, LogAroundTheChangeOfExponent) {
  for (int k = -1022; k <= 1023; ++k)
    for (const double mantissa :
         {1.0, 0x1.6a09e667f3bccp0, 0x1.6a09e667f3bcdp0, 0x1.fffffffffffffp0}) {
      const double x = std::ldexp(mantissa, k);
      const long double exact = std::log(static_cast<long double>(x));
      const double got = log(Real{x, x})[1];
      if (std::abs(got - exact) > 1e-16L) {
        ASSERT_LT(units_off(got, exact), 3.0) << x;
      }
    }
}

TEST(SimdMath, SqrtAgainstLibrary) {
  test::Random random(3);
  for (int i = 0; i < 200000; ++i) {
    const double x = i % 3 == 0 ? 1.0 + 0.5 * random() : std::exp(600.0 * random());
    const Real found = sqrt(Real{x, 1.0 / x});
    ASSERT_LT(units_off(found[0], std::sqrt(static_cast<long double>(x))), 3.0) << x;
    ASSERT_LT(units_off(found[1], std::sqrt(static_cast<long double>(1.0 / x))), 3.0) << 1.0 / x;
  }
  EXPECT_EQ(sqrt(Real{0.0, 4.0})[0], 0.0);
}

TEST(SimdMath, InverseCubeRootAgainstLibrary) {
  test::Random random(4);
  for (int i = 0; i < 200000; ++i) {
    const double x = i % 3 == 0 ? 1.0 + 0.5 * random() : std::exp(600.0 * random());
    const Real found = inverse_cube_root(Real{x, 1.0 / x});
    ASSERT_LT(units_off(found[0], 1.0L / std::cbrt(static_cast<long double>(x))), 3.0) << x;
    ASSERT_LT(units_off(found[1], 1.0L / std::cbrt(static_cast<long double>(1.0 / x))), 3.0) << x;
  }
  EXPECT_EQ(inverse_cube_root(Real{1.0, 1.0})[0], 1.0);
  for (int i = 0; i < 200000; ++i) {
    const double t = 0.2 * random();
    const Real found = inverse_cube_root_near_one(Real{t, i % 2 == 0 ? 0.2 : -0.2});
    const long double end = i % 2 == 0 ? 1.2L : 0.8L;
    ASSERT_LT(units_off(found[0], 1.0L / std::cbrt(1.0L + t)), 3.0) << t;
    ASSERT_LT(units_off(found[1], 1.0L / std::cbrt(end)), 3.0) << i;
  }
}

TEST(SimdMath, ExpAgainstLibrary) {
  test::Random random(2);
  for (int i = 0; i < 200000; ++i) {
    const double x = i % 3 == 0 ? random() : 699.9 * random();
    const Real found = exp(Real{x, -x});
    ASSERT_LT(units_off(found[0], std::exp(static_cast<long double>(x))), 3.0) << x;
    ASSERT_LT(units_off(found[1], std::exp(static_cast<long double>(-x))), 3.0) << -x;
  }
  EXPECT_EQ(exp(Real{0.0, 0.0})[0], 1.0);
}

}  // namespace
}  // namespace rebound::fem
