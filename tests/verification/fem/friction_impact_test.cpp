// Coulomb friction of the contact: what it must and must not change.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/fem_impacts.hpp"

namespace rebound {
namespace {

const Mesh& graded_mesh() {
  static const Mesh made = generate_sphere_mesh({.radius = 0.0331, .cells = 1000, .grading = 30.0});
  return made;
}
const Mesh& even_mesh() {
  static const Mesh made = generate_sphere_mesh({.radius = 0.0331, .cells = 500});
  return made;
}

FemResult rubbing(double speed, double friction, double poisson_ratio, const Mesh& mesh) {
  FemProblem problem = test::common_case(speed);
  problem.material.poisson_ratio = poisson_ratio;
  problem.plate.friction = friction;
  return test::checked_impact(mesh, problem);
}

double lost_by_friction(const FemResult& result) {
  return result.energies.back().friction;
}

TEST(FrictionImpact, StiffensLittleAndLessTheCloserToIncompressible) {
  // No slip against no friction, static: by at most ln(3 − 4ν)/(1 − 2ν) of a flat
  // punch over its frictionless 1/(1 − ν): 9.9 % in k at ν = 0, 0.9 % at 0.4; F_max
  // goes as k^0.4. A contact that grows sticks with less.
  constexpr double no_slip = 5.0;  // the largest that is allowed: no traction ratio reaches it
  for (const double poisson_ratio : {0.0, 0.4}) {
    const double smooth = rubbing(0.1, 0.0, poisson_ratio, graded_mesh()).scalars.peak_force;
    const double stuck = rubbing(0.1, no_slip, poisson_ratio, graded_mesh()).scalars.peak_force;
    const double punch =
        (1 - poisson_ratio) * std::log(3 - 4 * poisson_ratio) / (1 - 2 * poisson_ratio);
    EXPECT_GT(stuck / smooth, 1.0) << poisson_ratio;
    EXPECT_LT(stuck / smooth, std::pow(punch, 0.4) + 1e-3) << poisson_ratio;
  }
}

TEST(FrictionImpact, LosesMostBetweenNoneAndNoSlip) {
  EXPECT_EQ(lost_by_friction(rubbing(15, 0.0, 0.4, even_mesh())), 0.0);
  const double little = lost_by_friction(rubbing(15, 0.01, 0.4, even_mesh()));
  const double some = lost_by_friction(rubbing(15, 0.1, 0.4, even_mesh()));
  const double stuck = lost_by_friction(rubbing(15, 5.0, 0.4, even_mesh()));
  EXPECT_GT(little, 1e-4);
  EXPECT_GT(some, 1.5 * little);
  EXPECT_LT(stuck, some);
}

TEST(FrictionImpact, ActsOnAPlateThatMovesToo) {
  FemProblem problem = test::common_case(15);
  problem.plate = {.stiffness = 1e11, .mass = 1.0, .damping_ratio = 0.1, .friction = 0.2};
  const FemResult moving = test::checked_impact(even_mesh(), problem);
  const FemResult rigid = rubbing(15, 0.2, 0.4, even_mesh());
  EXPECT_NEAR(lost_by_friction(moving) / lost_by_friction(rigid), 1.0, 0.01);
  EXPECT_NEAR(moving.restitution_momentum, rigid.restitution_momentum, 1e-4);
}

}  // namespace
}  // namespace rebound
