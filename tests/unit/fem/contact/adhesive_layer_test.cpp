#include "fem/contact/adhesive_layer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fem/contact/moving_plate.hpp"
#include "fem/interface/adhesive_range.hpp"
#include "lumped/problem/error.hpp"
#include "meshes/generate/sphere_mesh.hpp"
#include "tests/support/fem_cases.hpp"

namespace rebound::fem {
namespace {

constexpr double radius = 0.0331;

/// Pull of a plate on a sphere at rest that touches it.
double pull_at_touch(int cells, const AdhesiveTraction& traction) {
  const Mesh mesh = generate_sphere_mesh({.radius = radius, .cells = cells});
  const Discretisation body = discretise(mesh, 0.0896);
  const AdhesiveLayer layer(body, traction);
  double sum = 0.0;
  for (std::size_t i = 0; i < body.contact_nodes.size(); ++i)
    sum += layer.pull(i, body.position[body.contact_nodes[i]][1]);
  return sum;
}

TEST(AdhesiveLayerTest, PullAtTouchIsDerjaguins) {
  for (const double range : {0.02 * radius, 0.1 * radius}) {
    const AdhesiveTraction traction{.work = 20.0, .range = range};
    const double derjaguin = 2.0 * std::numbers::pi * radius * traction.work;
    const double coarse = std::abs(pull_at_touch(250, traction) / derjaguin - 1.0);
    const double fine = std::abs(pull_at_touch(4000, traction) / derjaguin - 1.0);
    EXPECT_LT(coarse, 0.15) << range;
    EXPECT_LT(fine, 0.005) << range;
    EXPECT_LT(fine, 0.25 * coarse) << range;
  }
}

/// Areas of 1, 2, 4 m² at heights 0, 0.1 and 0.5; a fourth node that may not touch.
Discretisation four_nodes() {
  Discretisation body;
  body.position = {{0, 0}, {1, 0.1}, {2, 0.5}, {0, 1}};
  body.mass = {1, 2, 3, 4};
  body.contact_nodes = {0, 1, 2};
  body.contact_area = {1, 2, 4};
  return body;
}

TEST(AdhesiveLayerTest, PullIsTheSlopeOfThePotential) {
  const AdhesiveLayer layer(four_nodes(), {.work = 3.0, .range = 0.4});
  constexpr double h = 1e-6;
  for (const double gap : {0.05, 0.2, 0.39, 0.41, 1.0})
    EXPECT_NEAR(layer.pull(1, gap),
                (layer.potential(1, gap + h) - layer.potential(1, gap - h)) / (2 * h), 1e-7)
        << gap;
  EXPECT_DOUBLE_EQ(layer.potential(1, 0.0), -2.0 * 3.0);
  EXPECT_EQ(layer.pull(1, 0.4), 0.0);
  // In contact the pull stays what it is at the plate.
  EXPECT_EQ(layer.pull(1, -0.01), layer.pull(1, 0.0));
}

TEST(AdhesiveLayerTest, BodyAndPlatePullEachOtherAlike) {
  const Discretisation body = four_nodes();
  test::Random random(11);
  for (int i = 0; i < 100; ++i) {
    MovingPlate plate(body,
                      {.stiffness = 1e-12, .mass = random.between(0.5, 5), .damping_ratio = 0.0},
                      {.work = 2.0, .range = 0.3});
    std::vector<double> u = random.vector(8, 0.2), v = random.vector(8, 4.0);
    for (double& value : u) value = std::abs(value);
    const auto before = v;
    plate.remember(v);
    const PlateStep step = plate.apply_contact(u, v, {.kick = 0.01, .drift = 0.01});
    double gained = 0.0;
    for (const int node : body.contact_nodes)
      gained += body.mass[node] * (v[2 * node + 1] - before[2 * node + 1]);
    EXPECT_GT(step.pull, 0.0);
    EXPECT_NEAR(step.impulse - step.pull, gained, 1e-12);
    // The plate takes the opposite: V I = M V², four times the mean of 0 and ½ M V² over a half.
    EXPECT_NEAR(plate.state().velocity * gained, 4.0 * plate.state().kinetic, 1e-12);
  }
}

FemProblem sticky(double work, double range) {
  FemProblem problem;
  problem.sphere = {.mass = 0.0896, .diameter = 2 * radius};
  problem.adhesion = {.work = work, .range = range};
  return problem;
}

std::string refused_key(double work, double range) {
  try {
    check_adhesion(sticky(work, range), Moduli::from_youngs(1e7, 0.4));
  } catch (const Error& error) {
    return error.location().key;
  }
  return "";
}

TEST(AdhesiveRangeTest, IsChosenByTheTaborNumber) {
  const Moduli moduli = Moduli::from_youngs(1e7, 0.4);
  const double plane_strain = 1e7 / (1 - 0.16);
  const double range = adhesive_range(sticky(50.0, 0.0), moduli);
  EXPECT_NEAR(std::cbrt(radius * 2500.0 / (plane_strain * plane_strain)) / range, 0.1, 1e-12);
  EXPECT_DOUBLE_EQ(adhesive_range(sticky(1e-3, 0.0), moduli), radius / 100);
  EXPECT_DOUBLE_EQ(adhesive_range(sticky(1500.0, 0.0), moduli), radius / 10);
  EXPECT_EQ(adhesive_range(sticky(50.0, 1e-3), moduli), 1e-3);
}

TEST(AdhesiveRangeTest, RefusesWhatTearsTheBallToThePlate) {
  EXPECT_EQ(refused_key(0.0, 0.0), "");
  EXPECT_EQ(refused_key(1000.0, 0.0), "");
  EXPECT_EQ(refused_key(2000.0, 0.0), "model.adhesion.work");
  EXPECT_EQ(refused_key(20.0, 1e-6), "model.adhesion.work");
  EXPECT_EQ(refused_key(-1.0, 0.0), "model.adhesion.work");
  EXPECT_EQ(refused_key(std::nan(""), 0.0), "model.adhesion.work");
  EXPECT_EQ(refused_key(20.0, 0.3 * radius), "model.adhesion.range");
  EXPECT_EQ(refused_key(20.0, -1e-3), "model.adhesion.range");
}

}  // namespace
}  // namespace rebound::fem
