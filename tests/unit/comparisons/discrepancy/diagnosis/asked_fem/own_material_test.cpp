#include "comparisons/discrepancy/diagnosis/asked_fem/own_material.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rebound {
namespace {

constexpr double contact_time = 1.6e-3;

/// As guess_fem_material() has it: one branch of 1/40 of the contact.
Material guess() {
  Material material{.youngs_modulus = 12e6,
                    .poisson_ratio = 0.35,
                    .modulus = ModulusBasis::long_term,
                    .branches = {}};
  material.branches = {{.ratio = 1.0, .relaxation_time = 0.025 * contact_time}};
  return material;
}

std::vector<double> starts_of(const MaterialUnknowns& numbers) {
  std::vector<CalibrationParameter> unknowns;
  numbers.add(unknowns);
  std::vector<double> x;
  for (const CalibrationParameter& one : unknowns) x.push_back(one.start);
  return x;
}

void expect_alike(const Material& found, const Material& material) {
  EXPECT_NEAR(found.youngs_modulus, material.youngs_modulus, 1e-12 * material.youngs_modulus);
  EXPECT_DOUBLE_EQ(found.poisson_ratio, material.poisson_ratio);
  EXPECT_EQ(found.modulus, material.modulus);
  ASSERT_EQ(found.branches.size(), material.branches.size());
  for (std::size_t k = 0; k < found.branches.size(); ++k) {
    EXPECT_NEAR(found.branches[k].ratio, material.branches[k].ratio, 1e-12);
    EXPECT_NEAR(found.branches[k].relaxation_time, material.branches[k].relaxation_time, 1e-15);
    EXPECT_EQ(found.branches[k].relaxes, material.branches[k].relaxes);
  }
}

TEST(OwnMaterial, ComesBackFromItsNumbers) {
  Material material = guess();
  material.youngs_modulus = 9e6;
  material.poisson_ratio = 0.41;
  material.branches = {
      {.ratio = 0.7, .relaxation_time = 0.02 * contact_time, .relaxes = Relaxes::deviator},
      {.ratio = 0.3, .relaxation_time = 0.1 * contact_time}};
  const MaterialUnknowns numbers(guess(), material);
  EXPECT_EQ(numbers.count(), 6u);
  EXPECT_EQ(starts_of(numbers).size(), 6u);
  expect_alike(numbers.at(starts_of(numbers)), material);
}

/// Loss without memory: a branch outlasts a sixth of the contact in no search.
TEST(OwnMaterial, BranchesHaveFadedWithinTheContact) {
  Material material = guess();
  material.branches.push_back({.ratio = 0.2, .relaxation_time = 3.0 * contact_time});
  std::vector<CalibrationParameter> unknowns;
  MaterialUnknowns(guess(), material).add(unknowns);
  ASSERT_EQ(unknowns.size(), 6u);
  EXPECT_LE(std::exp(unknowns[3].highest), contact_time / 12.0);
  EXPECT_LE(std::exp(unknowns[5].highest), contact_time / 6.0);
  EXPECT_DOUBLE_EQ(unknowns[5].start, unknowns[5].highest) << "a start beyond its bound is at it";
  for (const CalibrationParameter& one : unknowns) {
    EXPECT_LE(one.lowest, one.start) << one.name;
    EXPECT_LE(one.start, one.highest) << one.name;
  }
}

/// Fast branches act by ratio times time, and a search for another kind starts from what the first
/// has found.
TEST(OwnMaterial, ASlowerBranchSharesWhatTheFirstHasFound) {
  Material fitted = guess();
  fitted.branches.front().ratio = 0.8;
  const std::vector<Material> kinds = other_kinds_near(fitted, guess());
  ASSERT_EQ(kinds.size(), 2u);
  const auto viscosity = [](const Material& material) {
    double sum = 0.0;
    for (const PronyBranch& one : material.branches) sum += one.ratio * one.relaxation_time;
    return sum;
  };
  ASSERT_EQ(kinds[0].branches.size(), 2u);
  EXPECT_NEAR(viscosity(kinds[0]), viscosity(fitted), 1e-12 * viscosity(fitted));
  EXPECT_GT(kinds[0].branches[1].relaxation_time, kinds[0].branches[0].relaxation_time);
  ASSERT_EQ(kinds[1].branches.size(), 1u);
  EXPECT_EQ(kinds[1].branches[0].relaxes, Relaxes::deviator);
  EXPECT_EQ(kinds[1].branches[0].ratio, fitted.branches[0].ratio);
}

/// Laws differ in no number that a search has: what tells them apart is how near they come.
TEST(OwnMaterial, OtherLawsHaveTheSameNumbers) {
  Material fitted = guess();
  fitted.branches.front().ratio = 0.8;
  const std::vector<Material> laws = other_laws_near(fitted);
  ASSERT_EQ(laws.size(), 3u);
  for (const Material& law : laws) {
    EXPECT_NE(law.elastic, fitted.elastic);
    EXPECT_EQ(numbers_of(law), numbers_of(fitted));
    EXPECT_EQ(law.branches, fitted.branches);
    const MaterialUnknowns numbers(guess(), law);
    const Material found = numbers.at(starts_of(numbers));
    EXPECT_EQ(found.elastic, law.elastic);
    EXPECT_EQ(found.terms, law.terms);
    EXPECT_EQ(found.second_share, law.second_share);
  }
}

}  // namespace
}  // namespace rebound
