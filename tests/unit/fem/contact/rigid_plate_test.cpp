#include "fem/contact/rigid_plate.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rebound::fem {
namespace {

/// Three nodes of 1, 2, 3 kg at radii 0, 1, 2 and heights 0, 0.1, 0.5; the
/// fourth is not in the contact group.
Discretisation four_nodes() {
  Discretisation body;
  body.position = {{0, 0}, {1, 0.1}, {2, 0.5}, {0, 1}};
  body.mass = {1, 2, 3, 4};
  body.contact_nodes = {0, 1, 2};
  return body;
}

constexpr StepSpan span{.kick = 0.1, .drift = 0.1};

TEST(RigidPlateTest, LeavesAloneWhatDoesNotPenetrate) {
  RigidPlate plate(four_nodes());
  const std::vector<double> u(8, 0.0);
  std::vector<double> v = {0, 3, 0, -0.99, 0, 0, 0, -100};
  const auto before = v;
  plate.remember(v);
  const PlateStep step = plate.apply_contact(u, v, span);
  EXPECT_EQ(v, before);
  EXPECT_EQ(step.impulse, 0.0);
  EXPECT_EQ(step.constraint_work, 0.0);
  EXPECT_EQ(step.contact_radius, 0.0);
}

TEST(RigidPlateTest, CountsImpulseAndWorkOfACaughtNode) {
  RigidPlate plate(four_nodes());
  std::vector<double> u(8, 0.0);
  u[2] = 0.25;  // node 1 has moved outwards
  std::vector<double> v = {0, 1, 0, -4, 0, 0, 0, 0};
  plate.remember(v);
  v[3] = -5;  // what the internal forces made of it
  const PlateStep step = plate.apply_contact(u, v, span);
  EXPECT_DOUBLE_EQ(v[3], -1.0);  // arrives on the plate: 0.1 − 0.1·1 = 0
  EXPECT_DOUBLE_EQ(step.impulse, 2.0 * (-1.0 + 5.0));
  EXPECT_DOUBLE_EQ(step.constraint_work, 0.5 * step.impulse * (-4.0 - 1.0));
  EXPECT_DOUBLE_EQ(step.contact_radius, 1.25);
  EXPECT_EQ(v[1], 1.0);
}

TEST(RigidPlateTest, WorkAndKickCloseTheEnergyOfTheNode) {
  // Kinetic energy changes by the work of internal force and plate together.
  RigidPlate plate(four_nodes());
  const std::vector<double> u(8, 0.0);
  std::vector<double> v = {0, 0, 0, -4, 0, 0, 0, 0};
  plate.remember(v);
  const double from_inside = 2.0 * (-5.0 - -4.0);
  v[3] = -5;
  const PlateStep step = plate.apply_contact(u, v, span);
  const double change = 0.5 * 2.0 * (v[3] * v[3] - 4.0 * 4.0);
  EXPECT_NEAR(step.constraint_work + from_inside * 0.5 * (-4.0 + v[3]), change, 1e-14);
}

TEST(RigidPlateTest, OnlyPushes) {
  RigidPlate plate(four_nodes());
  std::vector<double> u(8, 0.0);
  for (double z = -0.2; z <= 0.2; z += 0.01)
    for (double speed = -3; speed <= 3; speed += 0.1) {
      u[1] = z;
      std::vector<double> v(8, 0.0);
      v[1] = speed;
      plate.remember(v);
      const PlateStep step = plate.apply_contact(u, v, span);
      EXPECT_GE(step.impulse, 0.0);
      EXPECT_GE(v[1], speed);
      EXPECT_GE(z + span.drift * v[1], -1e-16);
    }
}

TEST(RigidPlateTest, GapIsThatOfTheLowestNode) {
  const RigidPlate plate(four_nodes());
  std::vector<double> u(8, 0.0);
  EXPECT_EQ(plate.gap(u), 0.0);
  u[1] = 0.3;
  EXPECT_EQ(plate.gap(u), 0.1);
  u[3] = -0.4;
  EXPECT_DOUBLE_EQ(plate.gap(u), -0.3);
}

TEST(FrictionTest, NodeSticksWithinTheConeAndSlidesOutsideIt) {
  const double impulse = 1.0 * 4.0;  // node 0 of 1 kg, stopped from 4 m/s
  for (const double speed : {-3.0, -0.5, 0.5, 3.0}) {
    RigidPlate plate(four_nodes(), {.friction = 0.3});
    const std::vector<double> u(8, 0.0);
    std::vector<double> v = {speed, -4, 7, 1, 0, 0, 0, 0};
    plate.remember(v);
    const PlateStep step = plate.apply_contact(u, v, span);
    const double within = 0.3 * impulse;
    const double expected = std::abs(speed) < within ? 0.0 : speed - std::copysign(within, speed);
    EXPECT_NEAR(v[0], expected, 1e-15);
    // No internal forces: the work is the kinetic energy lost along the plate.
    EXPECT_NEAR(step.friction_work, 0.5 * (expected * expected - speed * speed), 1e-14);
    EXPECT_EQ(v[2], 7.0);  // not pushed, not rubbed
  }
}

TEST(FrictionTest, NoneChangesNoBit) {
  RigidPlate plate(four_nodes(), {.friction = 0.0});
  const std::vector<double> u(8, 0.0);
  std::vector<double> v = {0.3, -4, 0.1, -5, 0, 0, 0, 0};
  plate.remember(v);
  const PlateStep step = plate.apply_contact(u, v, span);
  EXPECT_EQ(v[0], 0.3);
  EXPECT_EQ(v[2], 0.1);
  EXPECT_EQ(step.friction_work, 0.0);
}

}  // namespace
}  // namespace rebound::fem
