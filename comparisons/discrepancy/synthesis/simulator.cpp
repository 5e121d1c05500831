#include <algorithm>

#include "comparisons/discrepancy/synthesis/synthesize.hpp"
#include "comparisons/models/fem_access/mesh_for.hpp"
#include "comparisons/models/fem_access/module_loader.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

SimulatedImpact simulate_lumped(const SynthesisFile& file, const Sphere& sphere,
                                const Impact& impact) {
  LumpedProblem problem{.sphere = sphere, .impact = impact, .model = file.lumped, .controls = {}};
  problem.controls.samples = 2001;  // the data set samples this; it should not see the grid
  apply_effects(physical_effects(file.effects), problem);
  LumpedResult result = simulate(problem);
  return {.trace = std::move(result.trace),
          .scalars = result.scalars,
          .plate = problem.model.mechanisms.plate};
}

}  // namespace

ImpactSimulator simulator_of(const SynthesisFile& file, const RunControl& control) {
  if (file.tier == Tier::lumped)
    return [&file](const Sphere& sphere, const Impact& impact) {
      return simulate_lumped(file, sphere, impact);
    };
  FemProblem stated = file.fem;
  stated.sphere = file.sphere;
  stated.impact.speed =
      std::min_element(file.shots.begin(), file.shots.end(), [](const auto& a, const auto& b) {
        return a.speed < b.speed;
      })->speed;
  const Mesh mesh = mesh_for(stated, control);
  return [&file, mesh, control](const Sphere& sphere, const Impact& impact) {
    FemProblem problem = file.fem;
    problem.sphere = sphere;
    problem.impact = impact;
    apply_effects(physical_effects(file.effects), problem);
    FemResult result = fem_tier().simulate(problem, mesh, {.interrupted = control.interrupted});
    if (!result.incomplete_because.empty())
      throw Error(control.interrupted && control.interrupted() ? ExitCode::interrupted
                                                               : ExitCode::solver_failed,
                  "the hidden FE impact: " + result.incomplete_because);
    return SimulatedImpact{.trace = std::move(result.trace),
                           .scalars = result.scalars,
                           .plate = problem.plate,
                           .cells = result.cells};
  };
}

}  // namespace rebound
