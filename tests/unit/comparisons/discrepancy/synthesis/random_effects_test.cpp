#include "comparisons/discrepancy/synthesis/random_effects.hpp"

#include <gtest/gtest.h>

#include <set>

#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

SynthesisFile read(const std::string& further, int seed = 1) {
  return read_synthesis(Document::parse("schema = 1\nseed = " + std::to_string(seed) + R"(
[sphere]
mass = "89.6 g"
diameter = "66.2 mm"
[model]
tier = "lumped"
law = "hunt-crossley"
stiffness = "3.5e6 N/m^1.5"
damping = "8e4 N.s/m^2.5"
[[shot]]
speed = "5 m/s"
)" + further,
                                        "f.toml"));
}

TEST(RandomEffectsTest, TheSeedDecides) {
  const std::string random = "[random]\ncount = 2\n";
  const auto once = read(random).effects, again = read(random).effects;
  ASSERT_EQ(once.size(), 2u);
  EXPECT_EQ(once, again);
  EXPECT_NE(once[0].name, once[1].name);
  std::set<std::string> kinds;
  for (int seed = 1; seed <= 60; ++seed) kinds.insert(read(random, seed).effects[0].name);
  EXPECT_GT(kinds.size(), 15u);
}

// Every effect that is drawn is one that a file may name: size and parameters in their ranges.
TEST(RandomEffectsTest, WhatIsDrawnIsAllowed) {
  for (int seed = 1; seed <= 200; ++seed)
    for (const EffectChoice& effect : read("[random]\ncount = 3\n", seed).effects) {
      const EffectCard& card = find_effect(effect.name).card;
      EXPECT_TRUE(card.range.contains(effect.size)) << effect.name << " " << effect.size;
      EXPECT_NE(effect.size, card.null) << effect.name;
      EXPECT_FALSE(card.is_free_form) << effect.name;
    }
}

TEST(RandomEffectsTest, SizesAndSignsVary) {
  double lowest = 1e9, highest = 0.0;
  bool above = false, below = false;
  const double scale = find_effect("force-gain").card.prior_scale;
  for (int seed = 1; seed <= 100; ++seed) {
    const double size =
        read("[random]\ncount = 1\namong = [\"force-gain\"]\n", seed).effects.at(0).size;
    lowest = std::min(lowest, std::abs(size));
    highest = std::max(highest, std::abs(size));
    (size > 0.0 ? above : below) = true;
  }
  EXPECT_GE(lowest, scale / 3.0);
  EXPECT_LE(highest, scale * 3.0);
  EXPECT_GT(highest / lowest, 4.0);
  EXPECT_TRUE(above && below);
}

TEST(RandomEffectsTest, Refusals) {
  const auto key_of = [](const std::string& further) {
    try {
      read(further);
    } catch (const Error& error) {
      return error.location().key;
    }
    return std::string("none");
  };
  EXPECT_EQ(key_of("[random]\ncount = 2\namong = [\"gravity\"]\n"), "random.count");
  EXPECT_EQ(key_of("[random]\ncount = 1\namong = [\"plate-friction\"]\n"), "random.among[0]");
  EXPECT_EQ(key_of("[random]\ncount = 9\n"), "random.count");
}

}  // namespace
}  // namespace rebound
