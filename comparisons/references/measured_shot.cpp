#include "comparisons/references/measured_shot.hpp"

#include <fmt/format.h>

#include "lumped/problem/error.hpp"
#include "lumped/problem/scalars.hpp"

namespace rebound {

namespace {

double threshold_of(const Instrument& instrument) {
  if (instrument.contact_threshold) return *instrument.contact_threshold;
  return 3.0 * instrument.force_noise.value_or(0.0);
}

/// The samples of the contact, with time from zero.
Trace contact_of(const Trace& trace, bool has_deflection, double threshold) {
  std::size_t first = 0, last = trace.force.size();
  while (first < trace.force.size() && !(trace.force[first] > threshold)) ++first;
  if (first == trace.force.size())
    throw Error(ExitCode::bad_input,
                fmt::format("the force of a trace never exceeds {:.3g} N", threshold));
  while (!(trace.force[last - 1] > threshold)) --last;
  if (first > 0) --first;
  if (last < trace.force.size()) ++last;
  Trace contact;
  for (std::size_t i = first; i < last; ++i) {
    contact.time.push_back(trace.time[i] - trace.time[first]);
    contact.force.push_back(trace.force[i]);
    if (has_deflection) contact.deflection.push_back(trace.deflection[i]);
  }
  return contact;
}

void integrate_deflection(Trace& trace, double mass, double speed) {
  trace.deflection.assign(trace.time.size(), 0.0);
  double v = speed;
  for (std::size_t i = 1; i < trace.time.size(); ++i) {
    const double step = trace.time[i] - trace.time[i - 1];
    const double next = v - 0.5 * step * (trace.force[i] + trace.force[i - 1]) / mass;
    trace.deflection[i] = trace.deflection[i - 1] + 0.5 * step * (v + next);
    v = next;
  }
}

}  // namespace

ReferenceShot measured_shot(const Dataset& dataset, const Shot& shot) {
  if (!shot.trace) throw Error(ExitCode::bad_input, "the shot has no trace");
  ReferenceShot reference;
  reference.sphere = dataset.sphere;
  reference.impact = {.speed = shot.speed, .separation = SeparationRule::zero_force};
  reference.force_uncertainty = dataset.instrument.force_noise.value_or(0.0);
  reference.trace =
      contact_of(*shot.trace, shot.trace_has_deflection, threshold_of(dataset.instrument));
  if (!shot.trace_has_deflection)
    integrate_deflection(reference.trace, dataset.sphere.mass, shot.speed);
  const double momentum = dataset.sphere.mass * shot.speed;
  const double restitution = shot.restitution.value.value_or(
      integral(reference.trace.time, reference.trace.force) / momentum - 1.0);
  if (!(restitution > 0.0 && restitution <= 1.0))
    throw Error(ExitCode::bad_input,
                fmt::format("the impulse of the trace at {:.6g} m/s gives a restitution of {:.3g}",
                            shot.speed, restitution),
                {.key = "shot.trace", .value = shot.trace_file,
                 .allowed = "a restitution in (0, 1]; check units of force, mass and time"});
  reference.scalars = derive_scalars(reference.trace, reference.impact,
                                     reference.trace.time.back(), restitution * shot.speed);
  return reference;
}

}  // namespace rebound
