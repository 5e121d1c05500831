#include "comparisons/app/examples.hpp"

namespace rebound {
namespace {

constexpr Sphere core_a{.mass = 89.6e-3, .diameter = 66.2e-3};

}  // namespace

LumpedProblem example_lumped_problem() {
  LumpedProblem problem;
  problem.sphere = core_a;
  problem.impact.speed = 15.0;
  problem.model.law = "hunt-crossley";
  problem.model.parameters = {{"exponent", 1.5}, {"stiffness", 3.5e6}, {"damping", 17.63e4}};
  return problem;
}

FemProblem example_fem_problem() {
  FemProblem problem;
  problem.sphere = core_a;
  problem.impact.speed = 15.0;
  problem.material.youngs_modulus = 10e6;
  problem.material.poisson_ratio = 0.4;
  problem.material.branches = {{.ratio = 0.3, .relaxation_time = 0.3e-3}};
  return problem;
}

}  // namespace rebound
