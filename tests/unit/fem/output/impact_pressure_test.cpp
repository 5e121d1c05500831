// The pressure that pictures show: its integral, and Hertz's distribution.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tests/unit/fem/output/shown_impact.hpp"

namespace rebound::fem {
namespace {

using field_tests::Shown;
using field_tests::shown_impact;
using field_tests::sphere_of_frames;
using field_tests::underside;
using test::common_case;

/// ∫ p 2π r ds over the deformed underside, p and r linear between contact nodes.
double contact_force(const Discretisation& body, const test::Vtu& frame) {
  const auto nodes = underside(body);
  const auto& u = frame.values("displacement_m");
  const auto& p = frame.values("contact_pressure_Pa");
  const auto place = [&](int node) {
    return std::array{body.position[node][0] + u[3 * node],
                      body.position[node][1] + u[3 * node + 1]};
  };
  double force = 0.0;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const int first = nodes[i - 1], second = nodes[i];
    const auto a = place(first), b = place(second);
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    const double middle = 0.25 * (p[first] + p[second]) * (a[0] + b[0]);
    force +=
        2.0 * std::numbers::pi * length / 6.0 * (p[first] * a[0] + 4.0 * middle + p[second] * b[0]);
  }
  return force;
}

TEST(PressureOfAnImpact, IntegratesToTheForceOfTheTrace) {
  FemProblem fast = common_case(15), sticky = common_case(0.5);
  sticky.adhesion.work = 20.0;  // [J/m²]: 4 N at touch, a seventh of the peak force
  for (const FemProblem& problem : {fast, sticky}) {
    const Shown shown = shown_impact(sphere_of_frames(), problem, 40);
    const Trace& trace = shown.result.trace;
    const double interval = trace.time[1] - trace.time[0], peak = shown.result.scalars.peak_force;
    int compared = 0;
    double least_force = 0.0;
    for (const test::Vtu& frame : shown.frames) {
      // The window is a part of the last four samples and the bins around them: its
      // mean lies between their extremes.
      const auto at = static_cast<std::size_t>(frame.time / interval);
      if (at < 5 || at + 1 >= trace.force.size()) continue;
      const auto [least, most] =
          std::minmax_element(trace.force.begin() + at - 5, trace.force.begin() + at + 2);
      const double force = contact_force(sphere_of_frames(), frame);
      EXPECT_GE(force, *least - 1e-3 * peak) << frame.time;
      EXPECT_LE(force, *most + 1e-3 * peak) << frame.time;
      least_force = std::min(least_force, force);
      ++compared;
    }
    EXPECT_GT(compared, 25);
    EXPECT_EQ(least_force<-1.0, problem.adhesion.work> 0.0);
  }
}

// p = p₀ √(1 − r²/a²), p₀ = 3F/(2πa²), a³ = 3 F R (1 − ν²)/(4E). The tolerances are
// what finite strain and some thirty nodes across the contact leave: found 0.5 % at
// the centre, 1.0 % of p₀ up to 0.96 a, and the outermost node below by 2.6 %.
TEST(PressureOfAnImpact, IsHertz) {
  const Mesh mesh = generate_sphere_mesh({.radius = 0.0331, .cells = 2000, .grading = 50});
  const auto body = discretise(mesh, 0.0896);
  const Shown shown = shown_impact(body, common_case(0.5), 60);
  const auto largest =
      std::max_element(shown.frames.begin(), shown.frames.end(), [&](const auto& a, const auto& b) {
        return contact_force(body, a) < contact_force(body, b);
      });
  const double force = contact_force(body, *largest);
  EXPECT_NEAR(force / shown.result.scalars.peak_force, 1.0, 0.01);
  const double radius = std::cbrt(0.75 * force * 0.0331 * (1.0 - 0.16) / 10e6);
  const double peak = 1.5 * force / (std::numbers::pi * radius * radius);
  const auto& u = largest->values("displacement_m");
  const auto& p = largest->values("contact_pressure_Pa");
  EXPECT_NEAR(p[underside(body)[0]] / peak, 1.0, 0.01);
  int inside = 0;
  for (const int node : underside(body)) {
    const double x = (body.position[node][0] + u[3 * node]) / radius;
    const double hertz = x < 1.0 ? std::sqrt(1.0 - x * x) : 0.0;
    EXPECT_NEAR(p[node] / peak, hertz, x < 0.96 ? 0.013 : 0.04) << x;
    if (x < 1.0) ++inside;
  }
  EXPECT_GT(inside, 20);
}

}  // namespace
}  // namespace rebound::fem
