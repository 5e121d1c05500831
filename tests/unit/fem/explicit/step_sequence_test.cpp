// Which steps an explicit impact takes, and what must not decide them.
#include <gtest/gtest.h>

#include <cmath>

#include "fem/explicit/explicit_impact.hpp"
#include "meshes/generate/sphere_mesh.hpp"
#include "tests/support/fem_cases.hpp"

namespace rebound::fem {
namespace {

/// Every coordinate of `mesh` times 1 ± 1e-15 at random, the axis and the plate left where they
/// are.
Mesh rounded_otherwise(const Mesh& mesh, test::Random& random) {
  Mesh other = mesh;
  for (auto& vertex : other.vertices)
    for (double& x : vertex) x *= 1.0 + 1e-15 * random();
  return other;
}

TEST(StepSequenceTest, RoundingMovesNoStep) {
  test::Random random(23);
  for (const int cells : {120, 250})
    for (const double poisson_ratio : {0.0, 0.3, 0.4, 0.499})
      for (const double speed : {0.5, 15.0}) {
        FemProblem problem = test::common_case(speed);
        problem.material.poisson_ratio = poisson_ratio;
        const Mesh mesh = generate_sphere_mesh({.radius = 0.0331, .cells = cells});
        const FemResult as_made =
            run_explicit_impact(discretise(mesh, problem.sphere.mass), problem, {});
        for (int i = 0; i < 3; ++i) {
          const FemResult other = run_explicit_impact(
              discretise(rounded_otherwise(mesh, random), problem.sphere.mass), problem, {});
          SCOPED_TRACE(::testing::Message() << cells << " cells, Poisson ratio " << poisson_ratio
                                            << ", " << speed << " m/s, rounding " << i);
          EXPECT_EQ(other.steps, as_made.steps);
          EXPECT_NEAR(other.smallest_step / as_made.smallest_step, 1.0, 1e-11);
          // A step cut one step later moves the restitution by 1e-9 and more.
          EXPECT_NEAR(other.restitution_momentum, as_made.restitution_momentum, 1e-10);
        }
      }
}

}  // namespace
}  // namespace rebound::fem
