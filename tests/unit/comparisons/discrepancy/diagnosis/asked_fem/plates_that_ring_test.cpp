#include "comparisons/discrepancy/diagnosis/asked_fem/plates_that_ring.hpp"

#include <gtest/gtest.h>

namespace rebound {
namespace {

Observations a_shot_of_90_g() {
  Observations seen;
  seen.shots.push_back({.label = "a", .sphere = {.mass = 0.09, .diameter = 0.066}});
  return seen;
}

TEST(PlatesThatRing, HaveTheFrequencyOfTheFault) {
  constexpr double frequency = 1700.0;
  const EffectChoice burst{
      .name = "burst",
      .size = 600.0,
      .parameters = {{"frequency", frequency}, {"decay_time", 0.04}, {"instant", 1e-3}}};
  const auto plates = plates_that_ring(burst, a_shot_of_90_g());
  ASSERT_EQ(plates.size(), 2u);
  for (const EffectChoice& plate : plates)
    EXPECT_NEAR(find_effect("plate-compliance").card.oscillator->frequency_of(plate), frequency,
                1e-9 * frequency);
  EXPECT_GT(plates[0].parameters.at("mass"), plates[1].parameters.at("mass"));
}

TEST(PlatesThatRing, WhatDoesNotSwingIsNoPlate) {
  EXPECT_TRUE(
      plates_that_ring({.name = "clipping", .size = 5e3, .parameters = {}}, a_shot_of_90_g())
          .empty());
  EXPECT_TRUE(
      plates_that_ring({.name = "relaxation", .size = 0.1, .parameters = {}}, a_shot_of_90_g())
          .empty());
}

}  // namespace
}  // namespace rebound
