#include <gtest/gtest.h>

#include <set>

#include "comparisons/discrepancy/trials/generator/fem_materials.hpp"

namespace trials {
namespace {

/// What shows of an effect is what none of these does: each differs from the ball in one thing.
TEST(SoundBallsTest, AreOneChangeAwayFromEveryMaterial) {
  Random random({.seed = 1, .set = "sound"});
  for (const FemBall& kind : fem_materials()) {
    const FemBall ball = draw_material(1e7, 2e-3, kind, random);
    const std::vector<FemBall> near = sound_balls_near(ball, 2e-3);
    ASSERT_EQ(near.size(), 5u) << kind.material;
    std::set<std::string> laws{ball.elastic};
    for (std::size_t k = 2; k < near.size(); ++k) {
      laws.insert(near[k].elastic);
      EXPECT_EQ(near[k].branches.size(), ball.branches.size());
    }
    EXPECT_EQ(laws.size(), 4u) << "every law of the materials once";
    EXPECT_EQ(near[0].elastic, ball.elastic);
    EXPECT_GT(near[0].branches.back().ratio,
              ball.branches.size() > 1 ? ball.branches.back().ratio : 0.0);
    EXPECT_NEAR(near[0].branches.back().time, 0.08 * 2e-3, 1e-12);
    EXPECT_NE(near[1].branches.back().deviator_alone, ball.branches.front().deviator_alone);
    EXPECT_EQ(near[1].branches.back().time, ball.branches.front().time);
  }
}

}  // namespace
}  // namespace trials
