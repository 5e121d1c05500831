// Rung d: elastic impact of a sphere at 0.1, 0.5 and 1 m/s.
//
// Target: Hertz's impact with the finite-sphere correction, which is linear
// and quasi-static. FE is neither, so the distance grows with speed and does
// not fall under refinement: force +0.0/−1.5/−1.7 %, contact time +0.1/+0.9/+1.4 %
// at 1000 cells, and within 0.2 % of that at 4000. The tolerances say how
// linear and quasi-static these impacts are, not how fine the mesh is;
// ImpactConvergence does that.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "comparisons/verification/targets.hpp"
#include "tests/support/fem_impacts.hpp"

namespace rebound {
namespace {

using Rung = targets::SphereImpact;
constexpr auto& rungs = targets::sphere_impacts;

const FemResult& impact(const Rung& rung) {
  static std::map<double, FemResult> known;
  if (!known.contains(rung.speed)) {
    const FemProblem problem = test::common_case(rung.speed);
    const double radius = problem.sphere.radius();
    known[rung.speed] = test::checked_impact(
        generate_sphere_mesh({.radius = radius, .cells = 1000,
                              .grading = targets::low_speed_grading}),
        problem);
  }
  return known[rung.speed];
}

TEST(RungD, ForceTimeAndRestitution) {
  for (const Rung& rung : rungs) {
    const FemResult& result = impact(rung);
    EXPECT_NEAR(result.scalars.peak_force / rung.force, 1.0, rung.force_tolerance) << rung.speed;
    EXPECT_NEAR(result.scalars.contact_time / rung.time, 1.0, rung.time_tolerance) << rung.speed;
    EXPECT_GE(result.restitution_momentum, 0.998) << rung.speed;
    EXPECT_LT(result.restitution_momentum, 1.0) << rung.speed;
  }
}

TEST(RungD, HertzIsTheLimitOfSmallContacts) {
  // F = (5/4)^(3/5) k^(2/5) (m v²)^(3/5), k = (4/3) E/(1 − ν²) √R: the force is
  // above it by about C F/(E R) of the finite sphere, less the slower the impact.
  double before = 0.0;
  for (const Rung& rung : rungs) {
    const FemProblem problem = test::common_case(rung.speed);
    const double k = 4.0 / 3.0 * 10e6 / (1.0 - 0.16) * std::sqrt(problem.sphere.radius());
    const double hertz = std::pow(1.25, 0.6) * std::pow(k, 0.4) *
                         std::pow(problem.sphere.mass * rung.speed * rung.speed, 0.6);
    const double above = impact(rung).scalars.peak_force / hertz - 1.0;
    EXPECT_GT(above, before + 0.01) << rung.speed;
    before = above;
  }
  EXPECT_LT(before, 0.1);
}

TEST(RungD, VibrationIsWhatRestitutionMisses) {
  for (const Rung& rung : rungs) {
    const FemResult& result = impact(rung);
    const double e = result.restitution_momentum;
    EXPECT_NEAR(1.0 - e * e, result.vibrational_energy_share + result.contact_constraint_share, 1e-5)
        << rung.speed;
  }
}

}  // namespace
}  // namespace rebound
