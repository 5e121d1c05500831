#include "fem/impact/impact_conclusion.hpp"

#include <cmath>

#include "fem/impact/window_scalars.hpp"
#include "lumped/problem/scalars.hpp"

namespace rebound::fem {

void conclude_impact(const FemProblem& problem, const ImpactRecorder& recorder,
                     const ImpactEnd& end, FemResult& result) {
  const double v0 = problem.impact.speed, g = problem.gravity;
  const double rebound =
      recorder.total_impulse() / end.mass - end.touch_speed - g * end.last_contact;
  result.scalars = derive_scalars(result.trace, problem.impact, end.last_contact, rebound);
  const WindowScalars windows = window_scalars(recorder.half_windows(), end.last_contact);
  result.scalars.peak_force = windows.peak_force;
  result.scalars.contact_time_1pct = windows.contact_time_1pct;
  result.contact_time_tail = windows.contact_time_tail;
  result.force_averaging_window = 2.0 * recorder.half_windows().interval();
  result.window_force = recorder.half_windows().running_means(4);
  result.restitution_momentum = (end.speed + g * (end.time - end.last_contact)) / v0;
  const double expected = end.mass * (end.touch_speed + end.speed + g * end.time);
  result.closures.impulse =
      std::abs(integral(result.trace.time, recorder.contact_force()) - expected) / expected;
  result.closures.energy = end.energy_error;
  result.contact_radius_peak = end.contact_radius_peak;
  result.vibrational_energy_share =
      (end.energies.kinetic_vibration + end.energies.stored) / end.initial_kinetic;
  result.contact_constraint_share = end.energies.contact_constraint / end.initial_kinetic;
}

}  // namespace rebound::fem
