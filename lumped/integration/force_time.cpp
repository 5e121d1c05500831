#include "lumped/integration/force_time.hpp"

#include <algorithm>

#include "lumped/integration/checked_setup.hpp"
#include "lumped/integration/composed_contact.hpp"
#include "lumped/integration/composed_integrator.hpp"
#include "lumped/integration/sensitivity_names.hpp"
#include "lumped/integration/varied_step.hpp"
#include "lumped/laws/make_law.hpp"

namespace rebound {

namespace {

template <ContactLaw Law, std::size_t Width>
void fill(const Law& law, const ContactSetup& setup, const std::array<Direction, Width>& by,
          std::span<const double> instants, TimedForces& result) {
  FastIntegrator<Law, Width> run(law, setup, by);
  run.integrate();
  const auto knots = run.knots();
  std::vector<VariedStep<Law, Width>> steps;
  steps.reserve(knots.size());
  for (std::size_t k = 0; k + 1 < knots.size(); ++k) steps.emplace_back(law, run, k, by);
  const std::size_t columns = result.slopes.size() / instants.size();
  std::size_t k = 0;
  for (std::size_t i = 0; i < instants.size(); ++i) {
    const double instant = instants[i];
    if (!(instant >= 0.0 && instant <= knots.back().t)) continue;
    while (k > 0 && knots[k].t > instant) --k;
    while (k + 1 < steps.size() && knots[k + 1].t <= instant) ++k;
    const auto point = steps[k].at(fraction_at(knots[k], knots[k + 1], instant));
    result.force[i] = point.force.force;
    if (point.u > 0.0) result.rate[i] = point.rate(setup.mass) / (2.0 * point.u);
    for (std::size_t j = 0; j < columns; ++j)
      result.slopes[i * columns + j] = point.at_fixed_time(j, setup.mass);
  }
}

/// What the instrument reads of a composed contact, between its steps.
TimedForces composed(const LumpedProblem& problem, std::span<const double> instants) {
  const ComposedContact contact(problem);
  ComposedIntegrator run(contact);
  const ComposedEnd end = run.integrate();
  TimedForces result{std::vector<double>(instants.size()), {}, {}};
  for (std::size_t i = 0; i < instants.size(); ++i) {
    if (!(instants[i] >= 0.0 && instants[i] <= end.time)) continue;
    const auto after = std::upper_bound(
        run.knots().begin() + 1, run.knots().end(), instants[i],
        [](double time, const ComposedKnot& knot) { return time < knot.time; });
    const ComposedKnot& knot = *(after - 1);
    result.force[i] = contact.instrument_force(
        knot.phase, state_within(knot, (instants[i] - knot.time) / knot.length));
  }
  return result;
}

}  // namespace

TimedForces forces_at_instants(const LumpedProblem& problem, std::span<const double> instants,
                               std::span<const Direction> by) {
  const std::size_t count = instants.size();
  TimedForces result{std::vector<double>(count), std::vector<double>(count),
                     std::vector<double>(count * by.size())};
  if (count == 0) return result;
  if (by.empty() && ComposedContact::needed(problem)) return composed(problem, instants);
  require_bare(problem);
  const ContactSetup setup = checked_setup(problem);
  std::visit(
      [&]<class Law>(const Law& law) {
        if (by.empty()) return fill<Law, 0>(law, setup, {}, instants, result);
        with_width(by, [&](const auto& filled) { fill(law, setup, filled, instants, result); });
      },
      make_law(problem.model, problem.impact, problem.sphere));
  return result;
}

}  // namespace rebound
