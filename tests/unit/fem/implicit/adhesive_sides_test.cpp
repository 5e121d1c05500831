#include "fem/implicit/adhesive_sides.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "meshes/generate/sphere_mesh.hpp"
#include "tests/support/fem_cases.hpp"

namespace rebound::fem {
namespace {

constexpr double radius = 0.0331;

struct Sticky {
  QuadraticBody body = quadratic_body(generate_sphere_mesh({.radius = radius, .cells = 200}),
                                      {.radius = radius, .mass = 0.0896});
  AdhesiveTraction traction{.work = 20.0, .range = 0.1 * radius};
  AdhesiveSides sides{body, traction};

  Eigen::VectorXd random_field(double size, unsigned seed) const {
    test::Random random(seed);
    Eigen::VectorXd u(2 * body.node_count());
    for (double& value : u) value = size * random();
    return u;
  }
};

TEST(AdhesiveSidesTest, PullAtTouchIsDerjaguins) {
  const Sticky ball;
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(2 * ball.body.node_count());
  const double derjaguin = 2.0 * std::numbers::pi * radius * ball.traction.work;
  EXPECT_NEAR(ball.sides.pull(rest) / derjaguin, 1.0, 0.01);
  Eigen::VectorXd force = rest;
  ball.sides.add_forces(rest, force);
  EXPECT_NEAR(force.sum() / ball.sides.pull(rest), 1.0, 1e-12);
}

TEST(AdhesiveSidesTest, ForceIsTheGradientOfThePotential) {
  const Sticky ball;
  const auto u = ball.random_field(1e-4, 3), direction = ball.random_field(1.0, 4);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(u.size());
  ball.sides.add_forces(u, force);
  // Where a point leaves the range the potential has a kink in its second derivative.
  constexpr double h = 1e-8;
  const double slope =
      (ball.sides.potential(u + h * direction) - ball.sides.potential(u - h * direction)) / (2 * h);
  EXPECT_NEAR(slope / force.dot(direction), 1.0, 1e-6);
}

TEST(AdhesiveSidesTest, DerivativeIsThatOfTheForce) {
  const Sticky ball;
  const auto u = ball.random_field(1e-4, 3), direction = ball.random_field(1.0, 4);
  const SystemMatrix mass(ball.body, ContactInertia::kept);
  SystemMatrix matrix = mass;
  matrix.set(0.0, mass);
  ball.sides.add_derivative(u, matrix);
  const Eigen::VectorXd change = matrix.times(direction);
  constexpr double h = 1e-8;
  Eigen::VectorXd ahead = Eigen::VectorXd::Zero(u.size()), behind = ahead;
  ball.sides.add_forces(u + h * direction, ahead);
  ball.sides.add_forces(u - h * direction, behind);
  EXPECT_GT(change.norm(), 0.0);
  EXPECT_LT(((ahead - behind) / (2 * h) - change).norm(), 1e-5 * change.norm());
}

}  // namespace
}  // namespace rebound::fem
