// Both kinds of cells at Poisson ratios up to 0.499: the lowest spheroidal vibrations of a sphere
// change shape and hardly volume, so that cells which lock in volume miss them by far.
// Lamb's frequency equation for l = 2 and 3 (R = 33.1 mm, m = 89.6 g, E = 10 MPa), solved by
// bisection; at 0.4 it gives the targets of case b.
#include <gtest/gtest.h>

#include <cmath>

#include "comparisons/accuracy/verification/element_cases.hpp"
#include "comparisons/accuracy/verification/targets.hpp"
#include "fem/element_tests/element_checks.hpp"
#include "meshes/generate/sphere_mesh.hpp"
#include "tests/support/verification_rows.hpp"

namespace rebound {
namespace {

struct Lamb {
  double poisson_ratio, second, third;  // [-], [Hz], [Hz]
};
constexpr Lamb modes[] = {
    {0.45, 978.47847, 1466.2452}, {0.49, 966.46382, 1450.4435}, {0.499, 963.81658, 1446.9400}};

FreeVibration vibrate(double poisson_ratio, CellKind cells, int count) {
  const Mesh mesh =
      generate_sphere_mesh({.radius = targets::ball_radius, .cells = count, .grading = 1.0});
  return fem::element_checks().free_vibration(
      mesh, cells, VibratingMass::own,
      {.radius = targets::ball_radius,
       .mass = targets::ball_mass,
       .material = {.youngs_modulus = targets::ball_modulus, .poisson_ratio = poisson_ratio}});
}

/// Deviation of the frequency that is nearest [-].
double miss(const FreeVibration& found, double frequency) {
  double nearest = 1.0;
  for (const double one : found.frequencies)
    nearest = std::min(nearest, std::abs(one / frequency - 1.0));
  return nearest;
}

// Lamé's sphere, discs, an indented layer; the rows of `rebound verify`.
TEST(NearlyIncompressibleCells, KnownAnswers) {
  test::expect_rows(verify_nearly_incompressible(fem::element_checks()).rows, 28);
}

TEST(NearlyIncompressibleCells, FrequenciesOfTheSphere) {
  for (const Lamb& mode : modes) {
    for (const auto& [cells, count, tolerance] :
         {std::tuple{CellKind::bilinear, 1000, 2e-3}, {CellKind::nine_node, 120, 2e-4}}) {
      const FreeVibration found = vibrate(mode.poisson_ratio, cells, count);
      EXPECT_NEAR(found.frequencies.front() / mode.second, 1.0, tolerance)
          << mode.poisson_ratio << ", " << count << " cells";
      EXPECT_LT(miss(found, mode.third), 2.0 * tolerance)
          << mode.poisson_ratio << ", " << count << " cells";
    }
  }
}

}  // namespace
}  // namespace rebound
