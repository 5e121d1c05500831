// Nine-node cells with a linear volume ratio: forces, tangent, uniform states.
#include "fem/implicit/quadratic_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "fem/implicit/body_forces.hpp"
#include "tests/support/fem_cases.hpp"

namespace rebound::fem {
namespace {

const QuadraticBody& distorted_body() {
  static const QuadraticBody body = quadratic_body(test::distorted_cylinder(), {.mass = 2.5});
  return body;
}

Eigen::VectorXd random_field(double size, unsigned seed) {
  test::Random random(seed);
  Eigen::VectorXd u(2 * distorted_body().node_count());
  for (double& value : u) value = size * random();
  for (const int node : distorted_body().axis_nodes) u[2 * node] = 0.0;
  return u;
}

/// J^(−αβ) of a hyperfoam has αβ = 998 here: it bears a smaller motion.
double bearable(ElasticModel model) {
  return model == ElasticModel::hyperfoam ? 0.01 : 1.0;
}

Material rubber(ElasticModel model) {
  Material material = test::unit_material(model);
  material.poisson_ratio = 0.499;
  return material;
}

TEST(QuadraticMotionTest, ForceIsTheGradientOfTheEnergy) {
  for (const auto model : test::elastic_models) {
    const BodyForces forces(distorted_body(), rubber(model), ContactInertia::kept);
    const double size = bearable(model);
    const auto u = random_field(0.02 * size, 3), direction = random_field(size, 4);
    Eigen::VectorXd f;
    ASSERT_EQ(forces.forces(u, f), BodyForces::Outcome::done);
    const double energy = forces.stored_energy(u);
    const auto remainder = [&](double h) {
      return forces.stored_energy(u + h * direction) - energy - h * f.dot(direction);
    };
    EXPECT_NEAR(test::smallest_slope(remainder, 1e-3), 2.0, 0.1) << static_cast<int>(model);
  }
}

TEST(QuadraticMotionTest, TangentIsTheDerivativeOfTheForce) {
  for (const auto model : test::elastic_models) {
    Material material = rubber(model);
    material.branches = {{0.3, 0.4, Relaxes::all}};
    BodyForces forces(distorted_body(), material, ContactInertia::kept);
    const double size = bearable(model);
    forces.law().set_step(0.2);
    forces.accept(random_field(0.02 * size, 5));
    const auto u = random_field(0.02 * size, 3), direction = random_field(size, 4);
    Eigen::VectorXd f, moved, again;
    SystemMatrix k = forces.mass();
    ASSERT_EQ(forces.linearise(u, 0.0, f, k), BodyForces::Outcome::done);
    ASSERT_EQ(forces.forces(u, again), BodyForces::Outcome::done);
    EXPECT_LT((f - again).norm(), 1e-13 * f.norm());
    const Eigen::VectorXd change = k.times(direction);
    const auto remainder = [&](double h) {
      EXPECT_EQ(forces.forces(u + h * direction, moved), BodyForces::Outcome::done);
      return (moved - f - h * change).norm();
    };
    EXPECT_NEAR(test::smallest_slope(remainder, 1e-3), 2.0, 0.1) << static_cast<int>(model);
  }
}

// A volume ratio that varies linearly is what the cell has anyway.
TEST(QuadraticMotionTest, ProjectionLeavesLinearVolumeRatiosAlone) {
  const QuadraticBody& body = distorted_body();
  for (const QuadraticCell& cell : body.cells) {
    const DilatationProjection a = dilatation_projection(body, cell);
    Eigen::Matrix<double, quadratic_points, 1> linear, weight;
    for (int q = 0; q < quadratic_points; ++q) {
      double height = 0.0;
      for (int i = 0; i < quadratic_nodes; ++i)
        height += cell.points[q].shape[i] * body.position[cell.nodes[i]][1];
      linear[q] = 1.0 + 0.3 * cell.points[q].radius - 0.2 * height;
      weight[q] = cell.points[q].weight;
    }
    EXPECT_LT((a * linear - linear).norm(), 1e-13);
    // The volume of the cell stays what it is, whatever its points have.
    EXPECT_LT((a.transpose() * weight - weight).norm(), 1e-13 * weight.norm());
    EXPECT_NEAR(a.trace(), 3.0, 1e-12);  // three numbers are kept of nine
  }
}

TEST(QuadraticMotionTest, UniformStretchHasTheForcesOfTheLaw) {
  // A deviator that has not relaxed: the cells are of what it would become, the stress is not.
  Material slow = test::unit_material();
  slow.branches = {{0.9, 1e12, Relaxes::deviator}};
  const QuadraticBody& body = distorted_body();
  BodyForces shared(body, slow, ContactInertia::kept);
  const BodyForces own(body, test::unit_material(), ContactInertia::kept);
  ASSERT_TRUE(shared.law().constants().mean_dilatation);
  ASSERT_FALSE(own.law().constants().mean_dilatation);
  shared.law().set_step(1.0);
  Eigen::VectorXd u(own.size()), expected, found;
  for (int node = 0; node < body.node_count(); ++node) {
    u[2 * node] = -0.1 * body.position[node][0];
    u[2 * node + 1] = 0.2 * body.position[node][1];
  }
  ASSERT_EQ(own.forces(u, expected), BodyForces::Outcome::done);
  ASSERT_EQ(shared.forces(u, found), BodyForces::Outcome::done);
  EXPECT_LT((found - expected).norm(), 1e-11 * expected.norm());
}

TEST(QuadraticMotionTest, InsideOutIsSaid) {
  const BodyForces forces(distorted_body(), rubber({}), ContactInertia::kept);
  Eigen::VectorXd f;
  SystemMatrix k = forces.mass();
  EXPECT_EQ(forces.forces(random_field(2.0, 3), f), BodyForces::Outcome::inverted);
  EXPECT_EQ(forces.linearise(random_field(2.0, 3), 0.0, f, k), BodyForces::Outcome::inverted);
}

}  // namespace
}  // namespace rebound::fem
