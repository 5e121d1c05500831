// Impacts of a believed FE model are kept by what they were run on.
#include <gtest/gtest.h>

#include "comparisons/discrepancy/diagnosis/believed_fem/fem_belief.hpp"

namespace rebound {
namespace {

Observations one_shot() {
  Observations all;
  all.balls = {{.name = "ball", .sphere = {.mass = 0.0896, .diameter = 0.0662}}};
  MeasuredImpact shot;
  shot.sphere = all.balls.front().sphere;
  shot.impact.speed = 10.0;
  all.shots = {shot};
  return all;
}

Material of_one_branch() {
  Material material{.youngs_modulus = 10e6,
                    .poisson_ratio = 0.4,
                    .modulus = ModulusBasis::long_term,
                    .branches = {}};
  material.branches = {{.ratio = 1.0, .relaxation_time = 4e-5}};
  return material;
}

/// A branch of the same numbers that relaxes something else is another impact.
TEST(KeptImpacts, AreOfOneKindOfBranch) {
  const Material all_stress = of_one_branch();
  const FemBelief fem({}, one_shot(), {all_stress}, 100, {});
  const double restitution = fem.run(0, {.speed = 10.0}, all_stress, {}).scalars.restitution;
  Material other = all_stress;
  other.branches.front().relaxes = Relaxes::deviator;
  EXPECT_GT(fem.run(0, {.speed = 10.0}, other, {}).scalars.restitution, restitution + 0.002)
      << "a bulk that does not relax loses nothing";
  other = all_stress;
  other.relaxation = Relaxation::multiplicative;
  other.branches.front().rate_exponent = 0.5;
  EXPECT_NE(fem.run(0, {.speed = 10.0}, other, {}).scalars.restitution, restitution);
  EXPECT_EQ(fem.run(0, {.speed = 10.0}, all_stress, {}).scalars.restitution, restitution);
}

}  // namespace
}  // namespace rebound
