#include "comparisons/models/fem_access/material_stability.hpp"

#include <gtest/gtest.h>

#include "fem/interface/elastic_models.hpp"

namespace rebound {
namespace {

Material plateau(double softening) {
  Material material;
  material.youngs_modulus = 4e6;
  material.poisson_ratio = 0.3;
  material.strain.softening = softening;
  return material;
}

TEST(MaterialStabilityTest, APlateauThatFalls) {
  const auto unstable = unstable_stretch(plateau(0.95), {.smallest = 0.6, .largest = 1.05});
  ASSERT_TRUE(unstable.has_value());
  EXPECT_GT(*unstable, 0.85);
  EXPECT_LT(*unstable, 1.0);
}

TEST(MaterialStabilityTest, APlateauThatRises) {
  EXPECT_FALSE(unstable_stretch(plateau(0.7), {.smallest = 0.6, .largest = 1.3}).has_value());
  EXPECT_FALSE(may_be_unstable(plateau(0.7)));
  EXPECT_TRUE(may_be_unstable(plateau(0.95)));
}

TEST(MaterialStabilityTest, WhatIsNotReachedDoesNotCount) {
  EXPECT_FALSE(unstable_stretch(plateau(0.95), {.smallest = 0.98, .largest = 1.02}).has_value());
}

// Half as high and a quarter wider: 0.5 along, 1.25 across and around.
TEST(MaterialStabilityTest, StretchesAreThoseOfTheCells) {
  ShapeHistory shapes;
  shapes.cells = {{0, 1, 2, 3}};
  shapes.positions = {{{{1.0, 0.0}}, {{2.0, 0.0}}, {{2.0, 1.0}}, {{1.0, 1.0}}},
                      {{{1.25, 0.0}}, {{2.5, 0.0}}, {{2.5, 0.5}}, {{1.25, 0.5}}}};
  const StretchRange range = reached_stretches(shapes);
  EXPECT_NEAR(range.smallest, 0.5, 1e-12);
  EXPECT_NEAR(range.largest, 1.25, 1e-12);
}

TEST(MaterialStabilityTest, TheWarningNamesBothStrains) {
  ShapeHistory shapes;
  shapes.cells = {{0, 1, 2, 3}};
  shapes.positions = {{{{1.0, 0.0}}, {{2.0, 0.0}}, {{2.0, 1.0}}, {{1.0, 1.0}}},
                      {{{1.0, 0.0}}, {{2.0, 0.0}}, {{2.0, 0.7}}, {{1.0, 0.7}}}};
  const std::string warning = instability_warning(plateau(0.95), shapes);
  EXPECT_NE(warning.find("-30"), std::string::npos) << warning;
  EXPECT_TRUE(instability_warning(plateau(0.5), shapes).empty());
}

}  // namespace
}  // namespace rebound
