#include "lumped/integration/simulate.hpp"

#include <chrono>
#include <cmath>

#include "lumped/integration/checked_setup.hpp"
#include "lumped/integration/composed/composed_cvode.hpp"
#include "lumped/integration/composed/composed_integrator.hpp"
#include "lumped/integration/cvode/cvode_integrator.hpp"
#include "lumped/integration/fast/fast_integrator.hpp"
#include "lumped/integration/sample_instants.hpp"
#include "lumped/laws/make_law.hpp"
#include "lumped/problem/scalars.hpp"

namespace rebound {

namespace {

Closures closures_of(const AnyLaw& law, const ContactSetup& setup, const ContactEnd& end) {
  const double brought = 0.5 * setup.mass * setup.speed * setup.speed;
  const double kept = 0.5 * setup.mass * end.velocity * end.velocity;
  const double stored =
      std::visit([&](const auto& l) { return l.elastic_energy(end.deflection); }, law);
  const double momentum = setup.mass * (setup.speed - end.velocity);
  return {.impulse = std::abs(end.impulse - momentum) / momentum,
          .energy = std::abs(kept + stored + end.dissipated - brought) / brought};
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// One impact with mechanisms beside its law, by either integrator.
template <class Integrator>
LumpedResult simulate_composed(const LumpedProblem& problem) {
  const ComposedContact contact(problem);
  LumpedResult result;
  const auto start = std::chrono::steady_clock::now();
  Integrator integrator(contact);
  const ComposedEnd end = integrator.integrate();
  result.trace = integrator.sample(problem.controls);
  result.wall_seconds = seconds_since(start);
  result.scalars =
      derive_scalars(result.trace, problem.impact, end.time, -end.state[ComposedContact::velocity]);
  result.closures = contact.closures(end.phase, end.state, end.time);
  return result;
}

}  // namespace

LumpedResult simulate(const LumpedProblem& problem) {
  if (ComposedContact::needed(problem)) return simulate_composed<ComposedCvode>(problem);
  const AnyLaw law = make_law(problem.model, problem.impact, problem.sphere);
  const ContactSetup setup = checked_setup(problem);
  LumpedResult result;
  const auto start = std::chrono::steady_clock::now();
  CvodeIntegrator integrator(law, setup);
  const ContactEnd end = integrator.integrate();
  result.trace = integrator.sample(end, problem.controls);
  result.wall_seconds = seconds_since(start);
  result.scalars = derive_scalars(result.trace, problem.impact, end.time, -end.velocity);
  result.closures = closures_of(law, setup, end);
  return result;
}

LumpedResult simulate_fast(const LumpedProblem& problem) {
  if (ComposedContact::needed(problem)) return simulate_composed<ComposedIntegrator>(problem);
  const AnyLaw law = make_law(problem.model, problem.impact, problem.sphere);
  const ContactSetup setup = checked_setup(problem);
  LumpedResult result;
  const std::size_t samples = sample_count(problem.controls);
  result.trace.time.resize(samples);
  result.trace.force.resize(samples);
  result.trace.deflection.resize(samples);
  const auto start = std::chrono::steady_clock::now();
  const ContactEnd end = visit_stateless(
      [&]<class Law>(const Law& l) {
        FastIntegrator<Law> integrator(l, setup);
        fill_sample_instants(integrator.integrate().time, problem.controls, result.trace.time);
        integrator.sample({result.trace.time, result.trace.force, result.trace.deflection});
        return integrator.end();
      },
      law);
  result.wall_seconds = seconds_since(start);
  result.scalars = derive_scalars(result.trace, problem.impact, end.time, -end.velocity);
  result.closures = closures_of(law, setup, end);
  return result;
}

}  // namespace rebound
