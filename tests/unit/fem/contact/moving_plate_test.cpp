#include "fem/contact/moving_plate.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "fem/contact/rigid_plate.hpp"
#include "tests/support/fem_cases.hpp"

namespace rebound::fem {
namespace {

/// Nodes of 1, 2, 3 kg at heights 0, 0.1, 0.5 that may touch; a fourth that may not.
Discretisation four_nodes() {
  Discretisation body;
  body.position = {{0, 0}, {1, 0.1}, {2, 0.5}, {0, 1}};
  body.mass = {1, 2, 3, 4};
  body.contact_nodes = {0, 1, 2};
  return body;
}

constexpr StepSpan span{.kick = 0.1, .drift = 0.1};
constexpr double almost_free = 1e-12;  // [N/m]

TEST(MovingPlateTest, ExchangesMomentum) {
  const Discretisation body = four_nodes();
  test::Random random(3);
  for (int i = 0; i < 200; ++i) {
    MovingPlate plate(
        body, {.stiffness = almost_free, .mass = random.between(0.1, 10), .damping_ratio = 0.0});
    std::vector<double> u = random.vector(8, 0.2);
    for (double& value : u) value = std::abs(value);  // nothing starts below the plate
    std::vector<double> v = random.vector(8, 4.0);
    const auto before = v;
    plate.remember(v);
    const PlateStep step = plate.apply_contact(u, v, span);
    double gained = 0.0;
    for (const int node : body.contact_nodes)
      gained += body.mass[node] * (v[2 * node + 1] - before[2 * node + 1]);
    EXPECT_NEAR(step.impulse, gained, 1e-13);
    // The plate takes the same: V I = M V², four times the mean of 0 and ½ M V² over a half.
    EXPECT_NEAR(plate.state().velocity * step.impulse, 4.0 * plate.state().kinetic, 1e-12);
    EXPECT_LE(step.constraint_work, 1e-13);
  }
}

TEST(MovingPlateTest, NodesTouchOrAreFree) {
  // Complementarity: no penetration, no tension, and a push only where they touch.
  const Discretisation body = four_nodes();
  test::Random random(5);
  int touched = 0;
  for (int i = 0; i < 500; ++i) {
    MovingPlate plate(body, {.stiffness = 1e3, .mass = random.between(0.01, 10)});
    std::vector<double> u = random.vector(8, 0.3), v = random.vector(8, 5.0);
    const auto before = v;
    plate.remember(v);
    plate.apply_contact(u, v, span);
    const double surface = -span.drift * plate.state().velocity;
    for (const int node : body.contact_nodes) {
      const std::size_t k = 2 * node + 1;
      const double height = body.position[node][1] + u[k] + span.drift * v[k] - surface;
      EXPECT_GE(height, -1e-12);
      EXPECT_GE(v[k], before[k]);
      if (v[k] > before[k]) {
        EXPECT_NEAR(height, 0.0, 1e-12);
        ++touched;
      }
    }
    EXPECT_EQ(v[7], before[7]);
  }
  EXPECT_GT(touched, 300);
}

TEST(MovingPlateTest, HeavyOrStiffIsRigid) {
  const Discretisation body = four_nodes();
  for (const Plate& wall :
       {Plate{.stiffness = almost_free, .mass = 1e12}, Plate{.stiffness = 1e15, .mass = 1.0}}) {
    MovingPlate plate(body, wall);
    RigidPlate rigid(body);
    const std::vector<double> u(8, 0.0);
    std::vector<double> v = {0, -3, 0, -4, 0, -1, 0, -1}, expected = v;
    plate.remember(v);
    rigid.remember(v);
    const PlateStep a = plate.apply_contact(u, v, span);
    const PlateStep b = rigid.apply_contact(u, expected, span);
    for (int i = 0; i < 8; ++i) EXPECT_NEAR(v[i], expected[i], 1e-9);
    EXPECT_NEAR(a.impulse, b.impulse, 1e-9);
    EXPECT_NEAR(a.constraint_work, b.constraint_work, 1e-8);
    EXPECT_EQ(a.contact_radius, b.contact_radius);
  }
}

/// A plate struck once, then left to itself: the nodes are far away.
class StruckPlate {
 public:
  explicit StruckPlate(const Plate& plate) : plate_(four_nodes(), plate) {
    std::vector<double> u(8, 0.0), v(8, 0.0);
    v[1] = -1.0;
    plate_.remember(v);
    plate_.apply_contact(u, v, {.kick = step, .drift = step});
    plate_.drift(step);
  }
  PlateStep advance() {
    std::vector<double> u(8, 100.0), v(8, 0.0);
    plate_.remember(v);
    const PlateStep result = plate_.apply_contact(u, v, {.kick = step, .drift = step});
    plate_.drift(step);
    return result;
  }
  double energy() const {
    const PlateState s = plate_.state();
    return s.kinetic + s.spring + s.damper;
  }
  const MovingPlate& plate() const { return plate_; }
  static constexpr double step = 1e-3;

 private:
  MovingPlate plate_;
};

TEST(MovingPlateTest, FreeRingingKeepsItsEnergyWithTheDamperCounted) {
  for (const double damping : {0.0, 0.05, 3.0}) {
    StruckPlate struck({.stiffness = 4e4, .mass = 1.0, .damping_ratio = damping});  // ω Δt = 0.2
    struck.advance();
    const double first = struck.energy();
    ASSERT_GT(first, 0.1);
    for (int i = 0; i < 500; ++i) {
      struck.advance();
      EXPECT_NEAR(struck.energy() / first, 1.0, 1e-10);
    }
    if (damping > 0.0) {
      EXPECT_GT(struck.plate().state().damper, 0.9 * first);
    }
  }
}

TEST(MovingPlateTest, RingsAtItsOwnFrequency) {
  StruckPlate struck({.stiffness = 400.0, .mass = 1.0, .damping_ratio = 0.0});  // ω Δt = 0.02
  int crossings = 0;
  double before = struck.plate().state().displacement, first = 0.0, last = 0.0;
  for (int i = 0; i < 20000; ++i) {
    struck.advance();
    const double now = struck.plate().state().displacement;
    if (before * now < 0.0) {
      last = StruckPlate::step * (i + before / (before - now));
      if (crossings++ == 0) first = last;
    }
    before = now;
  }
  // Trapezoidal rule: tan(ω' Δt/2) = ω Δt/2.
  const double expected = 2.0 / StruckPlate::step * std::atan(0.5 * 20.0 * StruckPlate::step);
  EXPECT_NEAR(M_PI * (crossings - 1) / (last - first) / expected, 1.0, 1e-6);
}

TEST(MovingPlateTest, ReadingIsWhatSpringAndDamperCarry) {
  // Impulse given minus impulse read is the momentum the plate still has.
  StruckPlate struck({.stiffness = 4e4, .mass = 1.0, .damping_ratio = 0.1});
  const double first = struck.plate().state().velocity;
  double read = 0.0;
  for (int i = 0; i < 300; ++i) {
    read += struck.advance().reading;
    EXPECT_NEAR(first - read, struck.plate().state().velocity, 1e-12);
  }
}

TEST(MovingPlateTest, RingingThatCannotReachTheBodyIsOver) {
  StruckPlate struck({.stiffness = 4e4, .mass = 1.0, .damping_ratio = 0.0});
  const MovingPlate& plate = struck.plate();
  const double amplitude = 0.5 / 200.0;  // half the momentum of 1 kg m/s, over ω
  const Departure leaving{.speed = 1.0, .vibration = 0.0, .horizon = 1.0};
  std::vector<double> u(8, 1.1 * amplitude);
  EXPECT_TRUE(plate.is_clear_of(u, leaving));
  u.assign(8, 0.5 * amplitude);  // the plate comes back at 0.5 m/s within 16 ms
  EXPECT_TRUE(plate.is_clear_of(u, leaving));
  EXPECT_FALSE(plate.is_clear_of(u, {.speed = 0.01, .vibration = 0.0, .horizon = 1.0}));
  EXPECT_TRUE(plate.is_clear_of(u, {.speed = 0.01, .vibration = 0.0, .horizon = 5e-3}));
  EXPECT_FALSE(plate.is_clear_of(u, {.speed = 1.0, .vibration = amplitude, .horizon = 1.0}));
}

TEST(MovingPlateTest, BodyThatFollowsAFasterFreePlateIsClear) {
  StruckPlate struck({.stiffness = almost_free, .mass = 1.0, .damping_ratio = 0.0});
  const std::vector<double> u(8, 1e-4);
  EXPECT_TRUE(struck.plate().is_clear_of(u, {.speed = -0.4, .vibration = 1e-5, .horizon = 1.0}));
  EXPECT_FALSE(struck.plate().is_clear_of(u, {.speed = -0.6, .vibration = 1e-5, .horizon = 1.0}));
}

}  // namespace
}  // namespace rebound::fem
