#include "comparisons/discrepancy/diagnosis/missing_force/force_words.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/comparisons/discrepancy/diagnosis/missing_force/added_force_cases.hpp"

namespace rebound {
namespace {

using testing::AddedForce;

/// All that was said of a force over the seeds.
std::vector<std::string> words_of(const AddedForce& added) {
  constexpr int seeds = 4;
  std::vector<testing::TrueImpact> impacts;
  for (const double speed : {5.0, 11.0, 25.0})
    impacts.push_back(testing::true_impact({}, added, speed));
  LumpedModel believed;
  believed.parameters = {{"exponent", 1.5}, {"stiffness", 3.5e6}, {"damping", 8e4}};
  std::vector<std::string> all;
  for (int seed = 11; seed < 11 + seeds; ++seed) {
    const Observations seen = testing::observed(impacts, {}, static_cast<std::uint64_t>(seed));
    const MissingForce missing =
        find_missing_force(seen, fit_hypothesis(seen, {.believed = believed}));
    all.insert(all.end(), missing.in_words.begin(), missing.in_words.end());
  }
  return all;
}

long count_of(const std::vector<std::string>& words, const std::string& part) {
  return std::count_if(words.begin(), words.end(),
                       [&](const std::string& one) { return one.find(part) != std::string::npos; });
}

TEST(ForceWordsTest, AFrictionIsNeitherEvenNorOfTheRate) {
  const auto words = words_of(testing::friction);
  EXPECT_GE(count_of(words, "odd in the velocity"), 1);
  EXPECT_EQ(count_of(words, "even in the velocity"), 0);
  EXPECT_EQ(count_of(words, "grows with the rate"), 0);
  EXPECT_EQ(count_of(words, "no force stands out"), 0);
}

TEST(ForceWordsTest, ASpringIsEvenAndTheSameAtEveryRate) {
  const auto words = words_of(testing::cubic);
  EXPECT_GE(count_of(words, "even in the velocity"), 3);
  EXPECT_EQ(count_of(words, "odd in the velocity"), 0);
  EXPECT_EQ(count_of(words, "happened before"), 0);
}

TEST(ForceWordsTest, NothingIsMissingInNoise) {
  const auto words = words_of(testing::nothing);
  EXPECT_GE(count_of(words, "no force stands out"), 3);
}

}  // namespace
}  // namespace rebound
