#include "comparisons/accuracy/verification/mesh_family.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/refusals.hpp"

namespace rebound {
namespace {

/// Half-sine of 2 ms and 1 kN with a sine of the given period and size on top.
FemResult pulse(double size, double period) {
  FemResult result;
  result.scalars.contact_time = 2e-3;
  for (int i = 0; i <= 2000; ++i) {
    const double time = 1e-6 * i;
    result.trace.time.push_back(time);
    result.trace.force.push_back(1000.0 * std::sin(std::numbers::pi * time / 2e-3) +
                                 size * std::sin(2.0 * std::numbers::pi * time / period));
  }
  return result;
}

TEST(MeshFamilyTest, ATraceHasNoRippleAgainstItself) {
  EXPECT_EQ(ripple_between(pulse(5.0, 40e-6), pulse(5.0, 40e-6)), 0.0);
}

TEST(MeshFamilyTest, TheWindowDecidesWhatCounts) {
  // The mean over T of a sine of period P keeps sin(πT/P)/(πT/P) of it.
  const FemResult smooth = pulse(0.0, 1.0);
  const double argument = std::numbers::pi * 20e-6 / 80e-6;
  EXPECT_NEAR(ripple_between(pulse(10.0, 80e-6), smooth), 0.01 * std::sin(argument) / argument,
              1e-4);
  EXPECT_NEAR(ripple_between(pulse(10.0, 20e-6), smooth), 0.0, 1e-9);
}

TEST(MeshFamilyTest, TwoSamplesAreRefused) {
  FemResult result = pulse(0.0, 1.0);
  result.trace.time.resize(2);
  result.trace.force.resize(2);
  EXPECT_EQ(testing::refusal_of([&] { ripple_between(result, pulse(0.0, 1.0)); }).code(),
            ExitCode::bad_input);
}

}  // namespace
}  // namespace rebound
