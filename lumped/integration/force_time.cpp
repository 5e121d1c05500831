#include "lumped/integration/force_time.hpp"

#include <algorithm>

#include "lumped/integration/checked_setup.hpp"
#include "lumped/integration/composed/composed_contact.hpp"
#include "lumped/integration/composed/composed_integrator.hpp"
#include "lumped/integration/fast/step_sensitivities.hpp"
#include "lumped/integration/sensitivity_names.hpp"
#include "lumped/laws/make_law.hpp"

namespace rebound {

namespace {

template <ContactLaw Law, std::size_t Width>
void fill(const Law& law, const ContactSetup& setup, const std::array<Direction, Width>& by,
          std::span<const double> instants, TimedForces& result) {
  FastIntegrator<Law, Width> run(law, setup, by);
  run.integrate();
  const auto step_ends = run.step_ends();
  std::vector<StepWithSensitivities<Law, Width>> steps;
  steps.reserve(step_ends.size());
  for (std::size_t k = 0; k + 1 < step_ends.size(); ++k) steps.emplace_back(law, run, k, by);
  const std::size_t columns = result.slopes.size() / instants.size();
  std::size_t k = 0;
  for (std::size_t i = 0; i < instants.size(); ++i) {
    const double instant = instants[i];
    if (!(instant >= 0.0 && instant <= step_ends.back().t)) continue;
    while (k > 0 && step_ends[k].t > instant) --k;
    while (k + 1 < steps.size() && step_ends[k + 1].t <= instant) ++k;
    const auto point = steps[k].at(fraction_at(step_ends[k], step_ends[k + 1], instant));
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
        run.step_ends().begin() + 1, run.step_ends().end(), instants[i],
        [](double time, const ComposedStepEnd& step_end) { return time < step_end.time; });
    const ComposedStepEnd& step_end = *(after - 1);
    result.force[i] = contact.instrument_force(
        step_end.phase, state_within(step_end, (instants[i] - step_end.time) / step_end.length));
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
  visit_stateless(
      [&]<class Law>(const Law& law) {
        if (by.empty()) return fill<Law, 0>(law, setup, {}, instants, result);
        with_width(by, [&](const auto& filled) { fill(law, setup, filled, instants, result); });
      },
      make_law(problem.model, problem.impact, problem.sphere));
  return result;
}

}  // namespace rebound
