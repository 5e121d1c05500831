#include "comparisons/discrepancy/diagnosis/asked_fem/plates_of_lumped.hpp"

#include <gtest/gtest.h>

namespace rebound {
namespace {

/// A search whose believed model leaves a χ² of 1000, and one fit with these effects and that χ².
EffectSelection search_with(std::vector<EffectChoice> effects, double chi_square) {
  EffectSelection found;
  found.baseline.fit.chi_square = 1000.0;
  AssessedFit one;
  one.fit.effects = std::move(effects);
  one.fit.chi_square = chi_square;
  found.tried.push_back(std::move(one));
  return found;
}

Observations one_ball() {
  Observations seen;
  seen.shots.push_back({.label = "a", .sphere = {.mass = 0.09, .diameter = 0.066}});
  return seen;
}

const EffectChoice plate{.name = "plate-compliance",
                         .size = 2e-8,
                         .parameters = {{"mass", 5.0}, {"damping_ratio", 0.03}}};
const EffectChoice on_a_frame{.name = "plate-on-frame",
                              .size = 2e-8,
                              .parameters = {{"mass", 5.0},
                                             {"damping_ratio", 0.03},
                                             {"frame_stiffness_ratio", 2.0},
                                             {"frame_mass_ratio", 4.0}}};
const EffectChoice relaxation{.name = "relaxation", .size = 0.2, .parameters = {}};

TEST(PlatesOfLumped, AMassWithinTheBallIsNoPlate) {
  EXPECT_TRUE(is_plate("plate-compliance"));
  EXPECT_TRUE(is_plate("plate-on-frame"));
  EXPECT_FALSE(is_plate("internal-mode"));
  EXPECT_FALSE(is_plate("relaxation"));
}

TEST(PlatesOfLumped, OneAloneIsTriedAtEveryStrength) {
  const auto plates = plates_found(search_with({plate}, 100.0), one_ball());
  ASSERT_EQ(plates.size(), 6u);
  EXPECT_EQ(plates[0], plate);
  EXPECT_EQ(plates[1], plate);
  const auto frequency_of = find_effect("plate-compliance").card.oscillator->frequency_of;
  for (std::size_t k = 2; k < plates.size(); ++k)
    EXPECT_NEAR(frequency_of(plates[k]), frequency_of(plate), 1e-9 * frequency_of(plate));
}

TEST(PlatesOfLumped, OneOnAFrameIsTakenOutOfIt) {
  const auto plates = plates_found(search_with({on_a_frame}, 100.0), one_ball());
  ASSERT_FALSE(plates.empty());
  EXPECT_EQ(plates.front(), plate);
}

TEST(PlatesOfLumped, OneBesideOtherEffectsIsFoundAsItIs) {
  const auto plates = plates_found(search_with({relaxation, plate}, 100.0), one_ball());
  EXPECT_EQ(plates, std::vector<EffectChoice>{plate});
  EXPECT_TRUE(plates_found(search_with({relaxation}, 100.0), one_ball()).empty());
}

TEST(PlatesOfLumped, AloneItMustTakeHalfOfTheGapToBeWorthASearch) {
  EXPECT_FALSE(plates_worth_a_search(search_with({plate}, 499.0), one_ball()).empty());
  EXPECT_TRUE(plates_worth_a_search(search_with({plate}, 501.0), one_ball()).empty());
  EXPECT_TRUE(plates_worth_a_search(search_with({relaxation, plate}, 1.0), one_ball()).empty());
}

}  // namespace
}  // namespace rebound
