#include "lumped/integration/checked_setup.hpp"

namespace rebound {

ContactSetup checked_setup(const LumpedProblem& problem) {
  require_limits(problem.controls, {"controls"});
  return {.mass = problem.sphere.mass,
          .speed = problem.impact.speed,
          .separation = problem.impact.separation,
          .relative_tolerance = problem.controls.relative_tolerance,
          .most_steps = problem.controls.most_steps};
}

}  // namespace rebound
