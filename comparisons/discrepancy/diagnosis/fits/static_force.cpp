#include "comparisons/discrepancy/diagnosis/fits/static_force.hpp"

#include <cmath>
#include <variant>

#include "lumped/laws/make_law.hpp"
#include "lumped/mechanisms/elastic_force.hpp"
#include "lumped/mechanisms/reference_scales.hpp"

namespace rebound {
namespace {

/// What a branch still carries at the end of the loading, over the relaxed force.
double left_of(const RelaxationBranch& branch, double duration) {
  const double relaxed = branch.relaxation_time / duration;
  return branch.ratio * relaxed * -std::expm1(-1.0 / relaxed);
}

}  // namespace

double static_force(const LumpedProblem& problem, double deflection, double duration) {
  const AnyLaw law = make_law(problem.model, problem.impact, problem.sphere);
  const Mechanisms& mechanisms = problem.model.mechanisms;
  const ElasticForce elastic(law, mechanisms,
                             {.radius = 0.5 * problem.sphere.diameter, .speed = reference_speed});
  double share = 1.0 + left_of(mechanisms.relaxation, duration);
  for (const RelaxationBranch& branch : mechanisms.further_relaxation)
    share += left_of(branch, duration);
  std::visit(
      [&](const auto& one) {
        if constexpr (requires { one.branch(); }) share += left_of(one.branch(), duration);
      },
      law);
  return share * elastic.elastic_force(deflection);
}

}  // namespace rebound
