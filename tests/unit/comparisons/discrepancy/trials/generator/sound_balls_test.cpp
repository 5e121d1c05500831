#include <gtest/gtest.h>

#include <set>

#include "comparisons/discrepancy/trials/generator/fem_materials.hpp"

namespace trials {
namespace {

constexpr double contact_time = 2e-3;

FemBall ball_of(const FemBall& kind) {
  Random random({.seed = 1, .set = "sound"});
  return draw_material(1e7, contact_time, kind, random);
}

TEST(SoundBallsTest, MayHaveASlowerBranch) {
  for (const FemBall& kind : fem_materials()) {
    const FemBall ball = ball_of(kind);
    const FemBall slower = with_more_branches(ball, contact_time, {.slow = 1.0});
    EXPECT_GT(slower.branches.back().ratio,
              ball.branches.size() > 1 ? ball.branches.back().ratio : 0.0)
        << kind.material;
    EXPECT_NEAR(slower.branches.back().time, 0.08 * contact_time, 1e-12);
    EXPECT_EQ(slower.branches.size(), 2u);
  }
}

TEST(SoundBallsTest, MayHaveABranchOfTheOtherKind) {
  for (const FemBall& kind : fem_materials()) {
    const FemBall ball = ball_of(kind);
    const FemBall other = with_more_branches(ball, contact_time, {.of_other_kind = 1.0});
    EXPECT_EQ(other.branches.size(), ball.branches.size() + 1) << kind.material;
    EXPECT_NE(other.branches.back().deviator_alone, ball.branches.front().deviator_alone);
    EXPECT_EQ(other.branches.back().time, ball.branches.front().time);
  }
}

TEST(SoundBallsTest, HaveNoBranchBelowZero) {
  for (const FemBall& kind : fem_materials()) {
    const FemBall less =
        with_more_branches(ball_of(kind), contact_time, {.slow = -9.0, .of_other_kind = -9.0});
    EXPECT_EQ(less.branches.size(), 1u) << kind.material;
    EXPECT_EQ(less.branches.front().ratio, ball_of(kind).branches.front().ratio);
  }
}

TEST(SoundBallsTest, MayBeOfEveryOtherLawOfTheMaterials) {
  for (const FemBall& kind : fem_materials()) {
    const FemBall ball = ball_of(kind);
    std::set<std::string> laws{ball.elastic};
    for (const FemBall& other : other_laws_of(ball)) {
      laws.insert(other.elastic);
      EXPECT_EQ(other.branches.size(), ball.branches.size());
      EXPECT_EQ(other.modulus, ball.modulus);
    }
    EXPECT_EQ(laws.size(), 4u) << kind.material;
  }
}

}  // namespace
}  // namespace trials
