#include "lumped/integration/cvode/cvode_integrator.hpp"

#include <algorithm>
#include <array>

#include "lumped/integration/sample_instants.hpp"

namespace rebound {

namespace {

using State = std::array<double, ContactSystem::states>;

State first_touch(const ContactSetup& setup) {
  State y{};
  y[ContactSystem::velocity] = setup.speed;
  return y;
}

CvodeSystem system_of(const ContactSystem& system, SeparationRule rule) {
  return {.size = ContactSystem::states,
          .rate = [&](const double* y, double* rate) { system.derivative(y, rate); },
          .indicators =
              [&, rule](const double* y, double* indicator) {
                indicator[0] = y[ContactSystem::deflection];
                if (rule == SeparationRule::zero_force) indicator[1] = system.force(y);
              }};
}

CvodeTolerances tolerances_of(const ContactSetup& setup, const ContactScales& scales) {
  const double energy = 0.5 * setup.mass * setup.speed * setup.speed;
  const double r = setup.relative_tolerance;
  return {.relative = r,
          .absolute = {r * scales.deflection, r * setup.speed, r * setup.mass * setup.speed,
                       r * energy}};
}

}  // namespace

CvodeIntegrator::CvodeIntegrator(const AnyLaw& law, const ContactSetup& setup)
    : system_{law, setup.mass},
      setup_(setup),
      scales_(std::visit([&](const auto& l) { return contact_scales(l, setup); }, law)),
      solver_(system_of(system_, setup.separation), tolerances_of(setup, scales_),
              first_touch(setup)) {}

void CvodeIntegrator::reset() {
  const State y = first_touch(setup_);
  std::copy(y.begin(), y.end(), solver_.state());
}

ContactEnd CvodeIntegrator::integrate() {
  constexpr std::array<int, 2> falling = {-1, -1};
  const std::size_t roots = setup_.separation == SeparationRule::zero_force ? 2 : 1;
  reset();
  solver_.restart(0.0, {falling.data(), roots});
  const auto reached = solver_.advance(longest_contact * scales_.time, "integrating the contact");
  if (!reached.at_event) throw contact_does_not_end();
  double* y = solver_.state();
  if (reached.events[0]) y[ContactSystem::deflection] = 0.0;  // what is left is rounding
  const ContactEnd end = {reached.time, y[ContactSystem::deflection], y[ContactSystem::velocity],
                          y[ContactSystem::impulse], y[ContactSystem::dissipated]};
  require_rebound(end, setup_);
  return end;
}

Trace CvodeIntegrator::sample(const ContactEnd& end, const LumpedControls& controls) {
  std::vector<double> instants(sample_count(controls));
  fill_sample_instants(end.time, controls, instants);
  reset();
  solver_.restart(0.0);
  Trace trace;
  const auto record = [&](double time) {
    trace.time.push_back(time);
    trace.force.push_back(system_.force(solver_.state()));
    trace.deflection.push_back(solver_.state()[ContactSystem::deflection]);
  };
  record(0.0);
  for (std::size_t i = 1; i + 1 < instants.size(); ++i) {
    solver_.advance(instants[i], "sampling the contact");
    record(instants[i]);
  }
  solver_.state()[ContactSystem::deflection] = end.deflection;
  solver_.state()[ContactSystem::velocity] = end.velocity;
  record(end.time);
  return trace;
}

}  // namespace rebound
