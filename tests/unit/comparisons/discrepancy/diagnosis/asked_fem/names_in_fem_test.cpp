// Which names FE can be asked of.
#include "comparisons/discrepancy/diagnosis/asked_fem/names_in_fem.hpp"

#include <gtest/gtest.h>

namespace rebound {
namespace {

/// A curve with such a number once ended a whole diagnosis as bad input.
TEST(NamesInFemTest, ANumberThatFeDoesNotHaveIsNoFormThere) {
  EffectChoice curve{.name = "unloading-curve", .size = 0.1, .parameters = {}};
  EXPECT_TRUE(fem_can_state(curve));
  curve.parameters["growth"] = 0.05;
  EXPECT_FALSE(fem_can_state(curve));
}

// Whether damping follows is no question there, and where a foam's plateau begins is a constant.
TEST(NamesInFemTest, WhatIsAConstantInFeIsLeftOut) {
  EXPECT_TRUE(fem_can_state({.name = "foam-softening",
                             .size = 0.3,
                             .parameters = {{"damping_share", 1.0}, {"depth_over_radius", 0.02}}}));
}

TEST(NamesInFemTest, AnEffectWithAFormInFeCanBeAskedAndOneWithoutCannot) {
  EXPECT_TRUE(fem_can_state({.name = "relaxation", .size = 0.3, .parameters = {}}));
  EXPECT_TRUE(fem_can_state({.name = "plate-compliance", .size = 1e-8, .parameters = {}}));
  EXPECT_FALSE(fem_can_state({.name = "force-exponent", .size = 0.1, .parameters = {}}));
}

}  // namespace
}  // namespace rebound
