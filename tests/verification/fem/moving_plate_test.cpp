// Impact on a plate that gives way, against closed forms.
//
// Free plate: an elastic two-body impact. The finite sphere's static law
// x = δ_Hertz(F) − C F/(E R), C = 0.37 at ν = 0.4, with the reduced mass
// m_r = m M/(m + M) gives the largest force from the energy and the contact
// time by quadrature; M → ∞ is case d, with its tolerances.
#include <gtest/gtest.h>

#include <cmath>

#include "lumped/problem/scalars.hpp"
#include "tests/support/fem_impacts.hpp"

namespace rebound {
namespace {

constexpr double ball = 0.0896;       // [kg]
constexpr double almost_free = 1e-3;  // [N/m]: period of minutes

struct Expected {
  double force, time;
};

struct Pair {
  double reduced_mass, speed;
  double weight = 0.0;  ///< on the ball, the other a wall [N]
};

Expected finite_sphere_impact(const Pair& pair) {
  const double reduced_mass = pair.reduced_mass, speed = pair.speed;
  const double radius = 0.0331, youngs = 10e6, compliance = 0.37 / (youngs * radius);
  const double k = 4.0 / 3.0 * youngs / (1.0 - 0.16) * std::sqrt(radius);
  const auto energy = [&](double f) {
    const double approach = std::pow(f / k, 2.0 / 3.0) - compliance * f;
    return 0.4 * k * std::pow(f / k, 5.0 / 3.0) - 0.5 * compliance * f * f - pair.weight * approach;
  };
  const double brought = 0.5 * reduced_mass * speed * speed;
  double low = 2.0 * pair.weight, high = 1e4 * speed;
  for (int i = 0; i < 200; ++i)
    (energy(0.5 * (low + high)) < brought ? low : high) = 0.5 * (low + high);
  // dt = dx/dF dF / ẋ with F = F_max (1 − s²), which takes the root out of the end.
  constexpr int parts = 20000;
  double time = 0.0;
  for (int i = 0; i < parts; ++i) {
    const double s = (i + 0.5) / parts;
    const double f = low * (1.0 - s * s);
    const double slope = 2.0 / 3.0 * std::pow(f / k, 2.0 / 3.0) / f - compliance;
    const double approach = std::sqrt(2.0 * (brought - energy(f)) / reduced_mass);
    time += 2.0 * slope * 2.0 * low * s / (approach * parts);
  }
  return {low, time};
}

const Mesh& slow_mesh() {
  static const Mesh made = generate_sphere_mesh({.radius = 0.0331, .cells = 1000, .grading = 60.0});
  return made;
}
const Mesh& fast_mesh() {
  static const Mesh made = generate_sphere_mesh({.radius = 0.0331, .cells = 500});
  return made;
}

FemResult impact(double speed, const Plate& plate, const Mesh& mesh) {
  FemProblem problem = test::common_case(speed);
  problem.plate = plate;
  FemResult result = test::checked_impact(mesh, problem);
  EXPECT_LT(result.closures.energy, speed > 1 ? 2e-4 : 1e-5);
  return result;
}

const std::vector<double>& column(const FemResult& result, const std::string& name) {
  for (const auto& column : result.trace.further)
    if (column.name == name) return column.values;
  throw std::runtime_error("no column " + name);
}

TEST(MovingPlateImpact, TheClosedFormIsCaseDForAWall) {
  const Expected wall = finite_sphere_impact({ball, 0.1});
  // The correction is of first order in F/(E R²); the case's own is not.
  EXPECT_NEAR(wall.force / 6.722, 1.0, 2e-3);
  EXPECT_NEAR(wall.time / 4.944e-3, 1.0, 2e-3);
}

TEST(MovingPlateImpact, FreePlateIsATwoBodyImpact) {
  // The lighter the plate, the shorter the contact and the less quasi-static: for two equal
  // masses the force converges to 0.992 of the quasi-static one (10 000 cells), for three to one
  // within 0.005.
  struct Case {
    double plate_mass, tolerance;
  };
  for (const auto& [plate_mass, tolerance] :
       {Case{0.2 * ball, 0.02}, Case{ball, 0.01}, Case{3.0 * ball, 0.005}}) {
    const FemResult result = impact(
        0.1, {.stiffness = almost_free, .mass = plate_mass, .damping_ratio = 0.0}, slow_mesh());
    const Expected expected = finite_sphere_impact({ball * plate_mass / (ball + plate_mass), 0.1});
    const auto& force = column(result, "contact_force_N");
    EXPECT_NEAR(refined_peak(result.trace.time, force) / expected.force, 1.0, tolerance)
        << plate_mass;
    EXPECT_NEAR(result.scalars.contact_time / expected.time, 1.0, tolerance) << plate_mass;
    // Momentum, and relative speed restored but for the vibration of the ball.
    const double rebound = result.scalars.rebound_speed;
    const double plate_speed = std::sqrt(2.0 * result.energies.back().plate_kinetic / plate_mass);
    EXPECT_NEAR(plate_mass * plate_speed / (ball * (0.1 + rebound)), 1.0, 1e-6);
    EXPECT_NEAR((plate_speed + rebound) / 0.1, 1.0, 2e-3) << plate_mass;
  }
}

TEST(MovingPlateImpact, StiffOrHeavyIsRigid) {
  const FemResult rigid = impact(15, {}, fast_mesh());
  double before = 1.0;
  for (const double stiffness : {1e8, 1e9, 1e10}) {
    const FemResult result =
        impact(15, {.stiffness = stiffness, .mass = 0.5, .damping_ratio = 0.1}, fast_mesh());
    const double off = std::abs(result.scalars.peak_deflection / rigid.scalars.peak_deflection - 1);
    EXPECT_LT(off, 0.3 * before) << stiffness;
    before = off;
  }
  EXPECT_LT(before, 1e-4);
  const FemResult heavy =
      impact(15, {.stiffness = almost_free, .mass = 1e6, .damping_ratio = 0.0}, fast_mesh());
  EXPECT_NEAR(heavy.scalars.contact_time / rigid.scalars.contact_time, 1.0, 1e-5);
  EXPECT_NEAR(heavy.restitution_momentum, rigid.restitution_momentum, 1e-6);
}

TEST(MovingPlateImpact, FastLoadCellReadsTheContactForce) {
  // A cell whose period is short against the contact follows it: error (ω T)^−2.
  const FemResult result =
      impact(15, {.stiffness = 2e9, .mass = 0.5, .damping_ratio = 0.5}, fast_mesh());
  const auto& contact = column(result, "contact_force_N");
  const auto& displacement = column(result, "plate_displacement_m");
  const double peak = refined_peak(result.trace.time, contact);
  EXPECT_NEAR(refined_peak(result.trace.time, result.trace.force) / peak, 1.0, 0.01);
  EXPECT_NEAR(refined_peak(result.trace.time, displacement) * 2e9 / peak, 1.0, 0.01);
  EXPECT_NEAR(
      integral(result.trace.time, result.trace.force) / integral(result.trace.time, contact), 1.0,
      1e-4);
}

TEST(MovingPlateImpact, ScalarsAreOfTheContactForceWhateverTheCellRings) {
  const FemResult rigid = impact(15, {}, fast_mesh());
  const FemResult ringing =
      impact(15, {.stiffness = 50e6, .mass = 2.0, .damping_ratio = 0.0}, fast_mesh());
  const auto& contact = column(ringing, "contact_force_N");
  const double peak = refined_peak(ringing.trace.time, contact);
  EXPECT_NEAR(ringing.scalars.peak_force / peak, 1.0, 5e-3);
  EXPECT_NEAR(
      ringing.scalars.contact_time_1pct / time_above(ringing.trace.time, contact, 0.01 * peak), 1.0,
      5e-3);
  EXPECT_NEAR(ringing.scalars.contact_time_1pct / rigid.scalars.contact_time_1pct, 1.0, 0.03);
  EXPECT_NEAR(ringing.contact_time_tail / rigid.contact_time_tail, 1.0, 0.03);
  // What the cell reads is another number.
  EXPECT_GT(
      std::abs(time_above(ringing.trace, 0.01 * peak) / ringing.scalars.contact_time_1pct - 1),
      0.02);
}

TEST(MovingPlateImpact, RingingPlateDoesNotKeepTheRunAlive) {
  const FemResult rigid = impact(15, {}, fast_mesh());
  const FemResult ringing =
      impact(15, {.stiffness = 50e6, .mass = 2.0, .damping_ratio = 0.0}, fast_mesh());
  EXPECT_LT(ringing.trace.time.back(), 1.2 * rigid.trace.time.back());
  const auto& last = ringing.energies.back();
  EXPECT_GT(last.plate_kinetic + last.plate_spring, 1e-3);  // [J] still ringing
  EXPECT_LT(ringing.restitution_momentum, rigid.restitution_momentum);
  EXPECT_EQ(last.plate_damper, 0.0);
}

TEST(MovingPlateImpact, DamperCountsWhatItTakes) {
  const FemResult result =
      impact(15, {.stiffness = 5e6, .mass = 0.3, .damping_ratio = 0.3}, fast_mesh());
  EXPECT_GT(result.energies.back().plate_damper, 0.1);  // [J] of 10
}

TEST(GravityImpact, RaisesTheForceAndAddsItsImpulse) {
  FemProblem problem = test::common_case(0.1);
  const FemResult without = test::checked_impact(slow_mesh(), problem);
  problem.gravity = 9.81;
  const FemResult with = test::checked_impact(slow_mesh(), problem);
  EXPECT_LT(with.closures.energy, 1e-5);
  const double rise = with.scalars.peak_force - without.scalars.peak_force;
  const double expected = finite_sphere_impact({ball, 0.1, ball * 9.81}).force -
                          finite_sphere_impact({ball, 0.1}).force;
  EXPECT_GT(expected, 1.5 * ball * 9.81);   // first order, Hertz
  EXPECT_NEAR(rise / expected, 1.0, 0.03);  // half a per cent of the whole force
  const double impulse = integral(with.trace.time, with.trace.force);
  EXPECT_NEAR(impulse / (ball * (0.1 + with.scalars.rebound_speed) +
                         ball * 9.81 * with.scalars.contact_time),
              1.0, 1e-9);
  EXPECT_NEAR(with.restitution_momentum, 1.0, 2e-3);
}

TEST(GravityImpact, BallThatRestsReadsItsWeight) {
  // So lossy and slow that it does not leave: no scalars, but a load cell that
  // reads the weight in the end.
  FemProblem problem = test::common_case(0.05);
  problem.gravity = 9.81;
  problem.material.branches = {{0.8, 1e-3, Relaxes::all}};
  problem.plate = {.stiffness = 2e4, .mass = 0.05, .damping_ratio = 1.0};
  problem.controls.end_time = 0.12;
  const auto body = fem::discretise(generate_sphere_mesh({.radius = 0.0331, .cells = 200}), ball);
  const FemResult result = fem::run_explicit_impact(body, problem, {});
  EXPECT_NE(result.incomplete_because, "");
  const std::size_t n = result.trace.time.size();
  double mean = 0.0;
  for (std::size_t i = n - n / 4; i < n; ++i)
    mean += result.trace.force[i] / static_cast<double>(n / 4);
  EXPECT_NEAR(mean / (ball * 9.81), 1.0, 0.03);
}

}  // namespace
}  // namespace rebound
