#include "comparisons/models/fem_access/fem_runner.hpp"

#include "comparisons/models/fem_access/module_loader.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

FemRunner fem_runner(const Mesh& mesh, const Sphere& sphere, const RunControl& control) {
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
