#include "comparisons/evaluation/convert/matched_law.hpp"

#include <fmt/format.h>

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

#include "lumped/integration/simulate.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

Error no_match(const std::string& why) {
  return {ExitCode::solver_failed, "no parameters of this law return what is wanted: " + why};
}

double restitution_at(LumpedProblem& problem, const std::string& loss, double value) {
  problem.model.parameters[loss] = value;
  return simulate_fast(problem).scalars.restitution;
}

/// Sets the loss that returns e, whatever the stiffness now is.
void set_loss(LumpedProblem& problem, const std::string& loss, double wanted) {
  double low = problem.model.parameters.at(loss);
  if (!(low > 0.0)) throw no_match("there is no loss to start from");
  double high = low;
  const auto miss = [&](double logarithm) {
    return restitution_at(problem, loss, std::exp(logarithm)) - wanted;
  };
  for (int i = 0; i < 60 && miss(std::log(low)) < 0.0; ++i) low *= 0.5;
  for (int i = 0; i < 60 && miss(std::log(high)) > 0.0; ++i) high *= 1.5;
  if (miss(std::log(low)) < 0.0 || miss(std::log(high)) > 0.0)
    throw no_match(fmt::format("a restitution of {:.4g} is out of its reach", wanted));
  std::uintmax_t iterations = 100;
  const auto bracket =
      boost::math::tools::toms748_solve(miss, std::log(low), std::log(high),
                                        boost::math::tools::eps_tolerance<double>(44), iterations);
  problem.model.parameters[loss] = std::exp(0.5 * (bracket.first + bracket.second));
}

}  // namespace

LumpedModel matched_law(const MatchRequest& request) {
  LumpedProblem problem = request.start;
  const double e = request.wanted.restitution.value();
  set_loss(problem, request.loss_parameter, e);
  if (!request.wanted.contact_time) return problem.model;
  const double wanted = std::log(*request.wanted.contact_time);
  double& stiffness = problem.model.parameters.at("stiffness");
  double slope = -0.4;  // of ln t in ln κ for Hertz
  double last_stiffness = 0.0, last_miss = 0.0;
  for (int i = 0; i < 40; ++i) {
    const double miss = std::log(simulate_fast(problem).scalars.contact_time) - wanted;
    if (std::abs(miss) < 1e-11) return problem.model;
    const double here = std::log(stiffness);
    if (i > 0 && std::abs(here - last_stiffness) > 1e-12) {
      const double secant = (miss - last_miss) / (here - last_stiffness);
      if (secant < -0.05 && secant > -2.0) slope = secant;
    }
    last_stiffness = here;
    last_miss = miss;
    stiffness = std::exp(here - miss / slope);
    set_loss(problem, request.loss_parameter, e);
  }
  if (std::abs(last_miss) < 1e-8) return problem.model;
  throw no_match("the contact time is out of its reach");
}

}  // namespace rebound
