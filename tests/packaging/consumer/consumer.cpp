// One impact of each tier through the installed libraries.
#include <cstdio>

#include "lumped/integration/simulate.hpp"
#ifdef WITH_FEM
#include "comparisons/models/fem_access/module_loader.hpp"
#include "meshes/generate/sphere_mesh.hpp"
#endif

int main() {
  using namespace rebound;
  const Sphere ball{.mass = 0.0896, .diameter = 0.0662};
  LumpedProblem lumped{.sphere = ball, .impact = {.speed = 15.0}};
  lumped.model = {.law = "hunt-crossley",
                  .parameters = {{"stiffness", 3.5e6}, {"damping", 17.63e4}}};
  std::printf("lumped restitution %.6f\n", simulate(lumped).scalars.restitution);
#ifdef WITH_FEM
  FemProblem fem{.sphere = ball, .impact = {.speed = 15.0}};
  fem.material = {.youngs_modulus = 10e6, .poisson_ratio = 0.4};
  const Mesh mesh = generate_sphere_mesh({.radius = ball.radius(), .cells = 200});
  const FemResult result = fem_tier().simulate(fem, mesh, {});
  std::printf("fem restitution %.6f\n", result.scalars.restitution);
#endif
}
