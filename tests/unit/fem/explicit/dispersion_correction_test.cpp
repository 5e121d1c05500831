#include "fem/explicit/dispersion_correction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fem/explicit/body_motion.hpp"
#include "meshes/generate/sphere_mesh.hpp"
#include "tests/support/fem_cases.hpp"

namespace rebound::fem {
namespace {

Discretisation sphere() {
  return discretise(generate_sphere_mesh({.radius = 0.0331, .cells = 300}), 0.0896);
}

/// Bar of 50 mm whose nodes may touch with one end only, as `mesh` says.
Discretisation bar(int cells_along) {
  return discretise(
      test::cylinder(
          {.radius = 0.002, .length = 0.05, .cells_across = 1, .cells_along = cells_along}),
      0.01);
}

/// All cells alike: each takes half of what the step leaves.
DispersionCorrection uniform(const Discretisation& body, double safety) {
  return {body, std::vector<double>(body.cells.size(), 1.0), safety};
}

/// Share of a uniform mesh: 1 − q over 2, q the solution of q = s²/(1 + (1 − q)/2).
double share_at(double safety) {
  double q = safety;
  for (int i = 0; i < 100; ++i) q = safety * safety / (1.0 + 0.5 * (1.0 - q));
  return 0.5 * (1.0 - q);
}

std::vector<double> inverse_masses(const Discretisation& body) {
  std::vector<double> inverse(2 * (body.position.size() + 1), 0.0);
  for (int node = 0; node < body.node_count(); ++node)
    inverse[2 * node] = inverse[2 * node + 1] = 1.0 / body.mass[node];
  return inverse;
}

TEST(DispersionCorrectionTest, LeavesRigidMotionAndMomentum) {
  const Discretisation body = sphere();
  DispersionCorrection correction = uniform(body, 0.5);
  std::vector<double> rigid(2 * (body.position.size() + 1), 0.0);
  for (int node = 0; node < body.node_count(); ++node) rigid[2 * node + 1] = 3.0 * body.mass[node];
  const auto same = correction.corrected(inverse_masses(body), rigid);
  for (std::size_t i = 0; i < rigid.size(); ++i) EXPECT_NEAR(same[i], rigid[i], 1e-15);

  test::Random random(11);
  const auto force = random.vector(rigid.size(), 1.0);
  const auto moved = correction.corrected(inverse_masses(body), force);
  double before = 0.0, after = 0.0, change = 0.0;
  for (std::size_t i = 1; i < force.size(); i += 2) {
    before += force[i];
    after += moved[i];
    change += std::abs(moved[i] - force[i]);
  }
  EXPECT_NEAR(after, before, 1e-12);
  EXPECT_GT(change, 1.0);
}

// The one pass that steps go through, with the instructions of this machine.
TEST(DispersionCorrectionTest, AKickIsThatOfTheCorrectedForce) {
  const Discretisation body = sphere();
  DispersionCorrection correction = uniform(body, 0.5);
  const auto inverse = inverse_masses(body);
  test::Random random(13);
  const auto force = random.vector(inverse.size(), 1.0);
  const auto before = random.vector(inverse.size(), 1.0);
  auto velocity = before;
  correction.kick(0.25, inverse, force, velocity);
  const auto moving = correction.corrected(inverse, force);
  for (int i = 0; i < 2 * body.node_count(); ++i)
    EXPECT_EQ(velocity[i], before[i] - 0.25 * moving[i] * inverse[i]) << i;
}

TEST(DispersionCorrectionTest, LeavesTheStepSafe) {
  // Power iteration for the largest eigenvalue of M⁻¹ L: below α, since M_c is definite, so that
  // ω²(1 + α) at the shortened step is what it was at the full one.
  const Discretisation body = sphere();
  constexpr double safety = 0.6;
  DispersionCorrection correction = uniform(body, safety);
  const auto inverse = inverse_masses(body);
  test::Random random(5);
  std::vector<double> force = random.vector(inverse.size(), 1.0);
  double largest = 0.0;
  for (int round = 0; round < 300; ++round) {
    const auto moved = correction.corrected(inverse, force);
    double norm = 0.0;
    std::vector<double> gained(force.size());
    for (std::size_t i = 0; i < force.size(); ++i) {
      gained[i] = moved[i] - force[i];
      norm += gained[i] * gained[i] * inverse[i];
    }
    double held = 0.0;
    for (std::size_t i = 0; i < force.size(); ++i) held += force[i] * force[i] * inverse[i];
    largest = std::sqrt(norm / held);
    for (double& value : gained) value /= std::sqrt(norm);
    force = gained;
  }
  const double share = share_at(safety);
  EXPECT_GT(largest, 0.5 * share);
  EXPECT_LT(largest, share);
  EXPECT_NEAR(DispersionCorrection::step_factor(safety), 1.0 / std::sqrt(1.0 + share), 1e-12);
  EXPECT_DOUBLE_EQ(DispersionCorrection::step_factor(1.0), 1.0);
}

/// Rayleigh quotient of u_z = cos(k z) on a bar: its inertia with the mass of `kinetic`.
double inertia_of_wave(const Discretisation& body, double wave_number, double safety) {
  BodyMotion motion(body, 0.0, uniform(body, safety));
  for (int node = 0; node < body.node_count(); ++node)
    motion.velocity[2 * node + 1] = std::cos(wave_number * body.position[node][1]);
  return motion.kinetic();
}

TEST(DispersionCorrectionTest, TakesOutItsShareOfTheInertiaOfShortWaves) {
  // ½ m Σ cos² of the lumped mass is exact; the consistent mass of a wave is less by (k h)²/6
  // of it, and α of that is taken out, away from the end that may touch.
  constexpr double length = 0.05;
  const int cells = 50;
  const double h = length / cells, k = 8.0 * std::numbers::pi / length;
  const Discretisation body = bar(cells);
  const double lumped = 0.25 * 0.01;
  const double per_share = (2.0 - 2.0 * std::cos(k * h)) / 6.0;
  for (const double safety : {0.3, 0.9}) {
    const double expected = 1.0 - share_at(safety) * per_share;
    EXPECT_NEAR(inertia_of_wave(body, k, safety) / lumped, expected, 0.03 * (1.0 - expected) + 1e-5)
        << safety;
  }
  EXPECT_NEAR(inertia_of_wave(body, k, 1.0), lumped, 1e-12 * lumped);
}

}  // namespace
}  // namespace rebound::fem
