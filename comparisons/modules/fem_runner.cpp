#include "comparisons/modules/fem_runner.hpp"

#include "comparisons/modules/module_loader.hpp"
#include "lumped/problem/error.hpp"
#include "meshes/generate/sphere_mesh.hpp"

namespace rebound {

FemRunner fem_runner(const Sphere& sphere, int cells, const RunControl& control) {
  const Mesh mesh = generate_sphere_mesh({.radius = sphere.radius(), .cells = cells});
  const auto body = fem_tier().prepare(mesh, sphere.mass);
  const auto interrupted = control.interrupted;
  return [body, interrupted](const FemProblem& problem) {
    FemResult result = body->simulate(problem, {.interrupted = interrupted});
    if (interrupted && interrupted())
      throw Error(ExitCode::interrupted, "interrupted during an FE impact");
    return result;
  };
}

}  // namespace rebound
