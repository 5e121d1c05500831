#include "comparisons/accuracy/verification/known_impact.hpp"

#include <fmt/format.h>

#include "comparisons/accuracy/verification/targets.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

VerificationRow invariant(const char* what, const std::string& name, double value, double bound,
                          const char* source) {
  return {.case_id = "invariant",
          .quantity = fmt::format("{}, {}", what, name),
          .unit = "",
          .target = 0.0,
          .result = value,
          .tolerance = bound,
          .scale = ToleranceScale::absolute,
          .source = source};
}

}  // namespace

FemProblem ball_problem(FemScheme scheme, double speed) {
  FemProblem problem{
      .scheme = scheme,
      .sphere = {.mass = targets::ball_mass, .diameter = 2.0 * targets::ball_radius}};
  problem.impact.speed = speed;
  problem.material = {.youngs_modulus = targets::ball_modulus,
                      .poisson_ratio = targets::ball_poisson_ratio};
  return problem;
}

void require_complete(const std::string& incomplete_because, const RunControl& control,
                      const std::string& name) {
  if (incomplete_because.empty()) return;
  const bool stopped = control.interrupted && control.interrupted();
  throw Error(stopped ? ExitCode::interrupted : ExitCode::solver_failed,
              name + ": " + incomplete_because);
}

FemResult complete_impact(const FemTier& tier, const FemProblem& problem, const Mesh& mesh,
                          const RunControl& control, const std::string& name) {
  FemResult result =
      tier.simulate(problem, mesh, {.interrupted = control.interrupted, .progress = {}});
  require_complete(result.incomplete_because, control, name);
  return result;
}

VerificationTable invariants_of(const FemResult& result, const std::string& name) {
  return {invariant("impulse less change of momentum", name, result.closures.impulse, 1e-6,
                    "balance of momentum"),
          invariant("energy not accounted for", name, result.closures.energy, 1e-3,
                    "balance of energy"),
          invariant("restitution by force less by momentum", name,
                    result.scalars.restitution - result.restitution_momentum, 1e-6,
                    "balance of momentum")};
}

VerificationRow constraint_row(const FemResult& result, const std::string& name) {
  return invariant("constraint work over kinetic energy", name, result.contact_constraint_share,
                   3e-3, "nodes caught by the plate lose little");
}

}  // namespace rebound
