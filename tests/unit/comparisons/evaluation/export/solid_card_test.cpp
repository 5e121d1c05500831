#include "comparisons/evaluation/export/solid_card.hpp"

#include <gtest/gtest.h>

#include "fem/interface/elastic_models.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

Material solid() {
  return {.elastic = ElasticModel::mooney_rivlin, .youngs_modulus = 10e6, .poisson_ratio = 0.4};
}

// E = 10 MPa, ν = 0.4: μ = E/2.8, K = E/0.6.
TEST(SolidCardTest, ModuliOfTheCodes) {
  Material material = solid();
  material.second_share = 0.25;
  const SolidCard card = solid_card(material);
  EXPECT_NEAR(card.c10, 0.75 * 10e6 / 5.6, 1e-3);
  EXPECT_NEAR(card.c01, 0.25 * 10e6 / 5.6, 1e-3);
  EXPECT_NEAR(card.d1, 1.2e-7, 1e-18);
  EXPECT_TRUE(card.branches.empty());
}

// μ∞ = 1, branches 1 and 2 over it: μ₀ = 4, shares 1/4 and 1/2; the second relaxes the
// deviator alone, so that K₀ = 2 K∞ and the first takes half of it.
TEST(SolidCardTest, LongTermRatiosBecomeShares) {
  Material material = solid();
  material.modulus = ModulusBasis::long_term;
  material.poisson_ratio = 0.2;
  material.branches = {{.ratio = 1.0, .relaxation_time = 1e-3},
                       {.ratio = 2.0, .relaxation_time = 2e-3, .relaxes = Relaxes::deviator}};
  const SolidCard card = solid_card(material);
  EXPECT_DOUBLE_EQ(card.branches[0].deviator, 0.25);
  EXPECT_DOUBLE_EQ(card.branches[1].deviator, 0.5);
  EXPECT_DOUBLE_EQ(card.branches[0].volume, 0.5);
  EXPECT_EQ(card.branches[1].volume, 0.0);
  EXPECT_DOUBLE_EQ(card.instantaneous.shear, 4.0 * card.long_term.shear);
  EXPECT_DOUBLE_EQ(card.instantaneous.bulk, 2.0 * card.long_term.bulk);
  EXPECT_EQ(card.branches[1].relaxation_time, 2e-3);
}

TEST(SolidCardTest, BothDescriptionsAgree) {
  Material fast = solid(), slow = solid();
  fast.branches = {{.ratio = 0.3, .relaxation_time = 1e-4},
                   {.ratio = 0.2, .relaxation_time = 1e-3}};
  slow.modulus = ModulusBasis::long_term;
  slow.youngs_modulus = 0.5 * fast.youngs_modulus;
  slow.branches = {{.ratio = 0.6, .relaxation_time = 1e-4},
                   {.ratio = 0.4, .relaxation_time = 1e-3}};
  const SolidCard first = solid_card(fast), second = solid_card(slow);
  EXPECT_NEAR(first.c10 / second.c10, 1.0, 1e-14);
  EXPECT_NEAR(first.d1 / second.d1, 1.0, 1e-14);
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(first.branches[i].deviator, second.branches[i].deviator, 1e-14);
    EXPECT_NEAR(first.branches[i].volume, second.branches[i].volume, 1e-14);
  }
  EXPECT_NEAR(first.relaxing_deviator(), 0.5, 1e-14);
  EXPECT_NEAR(first.relaxing_volume(), 0.5, 1e-14);
}

// Weights are shares of μ₀; β of ν: ν/(1 − 2ν) = 2 at 0.4.
TEST(SolidCardTest, TermsOfAFoam) {
  Material material = solid();
  material.elastic = ElasticModel::hyperfoam;
  material.terms = {{.weight = 3.0, .exponent = 8.0}, {.weight = 1.0, .exponent = -2.0}};
  const SolidCard card = solid_card(material);
  EXPECT_NEAR(card.terms[0].shear / card.instantaneous.shear, 0.75, 1e-14);
  EXPECT_EQ(card.terms[1].exponent, -2.0);
  EXPECT_NEAR(card.terms[0].beta, 2.0, 1e-12);
}

TEST(SolidCardTest, RefusesWhatTheMaterialRefuses) {
  Material material = solid();
  material.branches = {{.ratio = 1.2, .relaxation_time = 1e-3}};
  EXPECT_THROW(solid_card(material), Error);
}

}  // namespace
}  // namespace rebound
