// Case d: elastic impact of a sphere at 0.1, 0.5 and 1 m/s.
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

#include "comparisons/accuracy/verification/targets.hpp"
#include "tests/support/fem_impacts.hpp"

namespace rebound {
namespace {

using KnownCase = targets::SphereImpact;
constexpr auto& known_cases = targets::sphere_impacts;

const FemResult& sphere_impact(const KnownCase& case_id) {
  static std::map<double, FemResult> known;
  if (!known.contains(case_id.speed)) {
    const FemProblem problem = test::common_case(case_id.speed);
    const double radius = problem.sphere.radius();
    known[case_id.speed] = test::checked_impact(
        generate_sphere_mesh(
            {.radius = radius, .cells = 1000, .grading = targets::low_speed_grading}),
        problem);
  }
  return known[case_id.speed];
}

TEST(VerificationCaseD, ForceTimeAndRestitution) {
  for (const KnownCase& case_id : known_cases) {
    const FemResult& result = sphere_impact(case_id);
    EXPECT_NEAR(result.scalars.peak_force / case_id.force, 1.0, case_id.force_tolerance)
        << case_id.speed;
    EXPECT_NEAR(result.scalars.contact_time / case_id.time, 1.0, case_id.time_tolerance)
        << case_id.speed;
    EXPECT_GE(result.restitution_momentum, 0.998) << case_id.speed;
    EXPECT_LT(result.restitution_momentum, 1.0) << case_id.speed;
  }
}

TEST(VerificationCaseD, HertzIsTheLimitOfSmallContacts) {
  // F = (5/4)^(3/5) k^(2/5) (m v²)^(3/5), k = (4/3) E/(1 − ν²) √R: the force is
  // above it by about C F/(E R) of the finite sphere, less the slower the impact.
  double before = 0.0;
  for (const KnownCase& case_id : known_cases) {
    const FemProblem problem = test::common_case(case_id.speed);
    const double k = 4.0 / 3.0 * 10e6 / (1.0 - 0.16) * std::sqrt(problem.sphere.radius());
    const double hertz = std::pow(1.25, 0.6) * std::pow(k, 0.4) *
                         std::pow(problem.sphere.mass * case_id.speed * case_id.speed, 0.6);
    const double above = sphere_impact(case_id).scalars.peak_force / hertz - 1.0;
    EXPECT_GT(above, before + 0.01) << case_id.speed;
    before = above;
  }
  EXPECT_LT(before, 0.1);
}

TEST(VerificationCaseD, VibrationIsWhatRestitutionMisses) {
  for (const KnownCase& case_id : known_cases) {
    const FemResult& result = sphere_impact(case_id);
    const double e = result.restitution_momentum;
    EXPECT_NEAR(1.0 - e * e, result.vibrational_energy_share + result.contact_constraint_share,
                1e-5)
        << case_id.speed;
  }
}

}  // namespace
}  // namespace rebound
