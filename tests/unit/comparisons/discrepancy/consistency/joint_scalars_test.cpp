#include "comparisons/discrepancy/consistency/joint_scalars.hpp"

#include <gtest/gtest.h>

#include <map>

#include "comparisons/discrepancy/consistency/joint_fit.hpp"
#include "comparisons/discrepancy/consistency/joint_observations.hpp"

namespace rebound {
namespace {

const std::string hidden = "foam-softening", rival = "strain-stiffening";
constexpr double middle_speed = 15.0;

FemProblem ball_of(double mass, double modulus, double ratio) {
  FemProblem problem{.sphere = {.mass = mass, .diameter = 66.2e-3}};
  problem.material.youngs_modulus = modulus;
  problem.material.poisson_ratio = 0.4;
  problem.material.modulus = ModulusBasis::long_term;
  problem.material.branches = {{.ratio = ratio, .relaxation_time = 2e-4}};
  return problem;
}

/// One ball, its believed FE model on few cells, and scalars that this very model gave with an
/// effect in it, each good to two per cent.
struct TestBall {
  Observations all;
  std::shared_ptr<const FemBelief> fem;
};

TestBall made_ball(const FemProblem& problem, double size) {
  TestBall ball;
  ball.all.balls = {{.name = "ball", .sphere = problem.sphere}};
  for (const double speed : {5.0, middle_speed, 25.0}) {
    MeasuredImpact shot{.label = "shot at " + std::to_string(speed)};
    shot.sphere = problem.sphere;
    shot.impact = {.speed = speed};
    ball.all.shots.push_back(shot);
  }
  constexpr int few_cells = 110;
  ball.fem = std::make_shared<const FemBelief>(
      problem, ball.all, std::vector<Material>{problem.material}, few_cells, RunControl{});
  const EffectChoice effect{.name = hidden, .size = size, .parameters = {}};
  for (MeasuredImpact& shot : ball.all.shots) {
    const ImpactScalars scalars = ball.fem->run(0, shot.impact, problem.material, {effect}).scalars;
    for (const ScalarQuantity& one : scalar_quantities) {
      const double value = scalars.*one.modelled;
      shot.*one.measured = {.value = value, .uncertainty = 0.02 * value};
    }
  }
  return ball;
}

/// The fits apart, as diagnose_scalars() hands them over, of two effects.
FitsOfEffects fits_of(const TestBall& ball, const std::vector<std::string>& effects) {
  FitsOfEffects fits;
  fits.seen = std::make_shared<const Observations>(subset(ball.all, {true, false, true}));
  fits.unseen = subset(ball.all, {false, true, false});
  fits.believed = fit_hypothesis(*fits.seen, {.believed = {}, .fem = ball.fem, .effects = {}});
  for (const std::string& name : effects)
    fits.tried.push_back(fit_extended(*fits.seen, fits.believed,
                                      {{.name = name, .size = 0.5, .parameters = {}}},
                                      SearchEffort::whole));
  return fits;
}

struct TwoBalls {
  FitsOfEffects first, second;
  std::vector<const FitsOfEffects*> both() const { return {&first, &second}; }
};

const FemProblem light = ball_of(89.6e-3, 3e6, 1.0), heavy = ball_of(110e-3, 5e6, 0.6);

TwoBalls balls_with(double first_size, double second_size,
                    const std::vector<std::string>& effects) {
  return {fits_of(made_ball(light, first_size), effects),
          fits_of(made_ball(heavy, second_size), effects)};
}

/// Made once: their fits take most of the time of these tests.
const TwoBalls& balls_alike() {
  static const TwoBalls balls = balls_with(0.6, 0.6, {hidden, rival});
  return balls;
}
const TwoBalls& balls_unlike() {
  static const TwoBalls balls = balls_with(0.7, 0.3, {hidden});
  return balls;
}

TEST(JointScalarsTest, OneHiddenSizeIsFoundAsOne) {
  const JointEffects found = try_effects_jointly(balls_alike().both());
  ASSERT_FALSE(found.effects.empty());
  EXPECT_EQ(found.effects.front().name, hidden);
  const JointVariant& chosen = found.effects.front().chosen();
  EXPECT_EQ(chosen.in_common, InCommon::everything);
  EXPECT_EQ(chosen.numbers, 1.0);
  ASSERT_EQ(chosen.of_balls.size(), 2u);
  for (const EffectChoice& one : chosen.of_balls) EXPECT_NEAR(one.size, 0.6, 0.05);
  EXPECT_GT(found.believed.all.fitted, 1.5);
  EXPECT_LT(chosen.gap.all.fitted, 0.1);
  EXPECT_EQ(chosen.gap.unseen_of_balls.size(), 2u);
  EXPECT_LT(*chosen.gap.all.unseen, 0.1 * *found.believed.all.unseen);
  // What all balls hold in common, each can hold alone: fits apart are never farther.
  for (const JointEffect& effect : found.effects) {
    std::map<InCommon, double> chi_square;
    for (const JointVariant& one : effect.variants) chi_square[one.in_common] = one.chi_square;
    EXPECT_LE(chi_square[InCommon::nothing], chi_square[InCommon::everything]) << effect.name;
  }
}

TEST(JointScalarsTest, TwoHiddenSizesStayTwo) {
  const JointEffects found = try_effects_jointly(balls_unlike().both());
  ASSERT_FALSE(found.effects.empty());
  EXPECT_EQ(found.effects.front().name, hidden);
  const JointVariant& chosen = found.effects.front().chosen();
  EXPECT_EQ(chosen.in_common, InCommon::nothing);
  EXPECT_EQ(chosen.numbers, 2.0);
  EXPECT_NEAR(chosen.of_balls[0].size, 0.7, 0.05);
  EXPECT_NEAR(chosen.of_balls[1].size, 0.3, 0.05);
}

// Nothing is common to them then: the joint fit has no less and no more to say.
TEST(JointScalarsTest, SizesOfEachBallAreThoseApart) {
  const std::vector<const FitsOfEffects*> apart = balls_unlike().both();
  const std::vector<const HypothesisFit*> fits{&apart[0]->tried.front(), &apart[1]->tried.front()};
  EffectChoice start = fits[0]->effects.back();
  start.size_of_balls = {start.size, fits[1]->effects.back().size};
  const BallsTogether balls = put_together(apart);
  const HypothesisFit fit = fit_together(balls, fits, start, {});
  EXPECT_LE(fit.chi_square, 1.01 * (fits[0]->chi_square + fits[1]->chi_square) + 1e-3);
  ASSERT_EQ(fit.effects.back().size_of_balls.size(), 2u);
  for (std::size_t ball = 0; ball < 2; ++ball)
    EXPECT_NEAR(fit.effects.back().size_of_balls[ball], start.size_of_balls[ball], 0.05);
}

TEST(JointScalarsTest, BallsTogetherHaveTheImpactsOfEachApart) {
  const TestBall first = made_ball(light, 0.0), second = made_ball(heavy, 0.0);
  const FemBelief together = FemBelief::together({first.fem, second.fem});
  const Impact impact{.speed = 12.0};
  EXPECT_EQ(together.material_of(1).youngs_modulus, heavy.material.youngs_modulus);
  EXPECT_EQ(together.run(0, impact, light.material, {}).scalars.peak_force,
            first.fem->run(0, impact, light.material, {}).scalars.peak_force);
  EXPECT_EQ(together.run(1, impact, heavy.material, {}).scalars.peak_force,
            second.fem->run(0, impact, heavy.material, {}).scalars.peak_force);
}

TEST(JointScalarsTest, BallsTogetherKeepTheirShots) {
  Observations one;
  one.balls = {{.name = "ball", .sphere = light.sphere}};
  MeasuredImpact shot{.label = "shot"};
  shot.impact.speed = 5.0;
  one.shots = {shot};
  Observations other = one;
  other.balls[0].sphere = heavy.sphere;
  other.shots[0].impact.speed = 7.0;
  const Observations all = balls_together({&one, &other});
  ASSERT_EQ(all.shots.size(), 2u);
  EXPECT_EQ(all.shots[1].ball, 1u);
  EXPECT_EQ(all.shots[1].impact.speed, 7.0);
  EXPECT_EQ(all.balls[1].sphere.mass, heavy.sphere.mass);
  EXPECT_NE(all.balls[0].name, all.balls[1].name);
  EXPECT_NE(all.shots[0].label, all.shots[1].label);
}

}  // namespace
}  // namespace rebound
