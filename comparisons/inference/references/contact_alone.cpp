#include "comparisons/inference/references/contact_alone.hpp"

#include <fmt/format.h>

#include "comparisons/io/dataset/contact_window.hpp"
#include "lumped/problem/error.hpp"
#include "lumped/problem/scalars.hpp"

namespace rebound {

namespace {

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

MeasuredImpact contact_alone(MeasuredImpact recorded) {
  if (!recorded.has_history()) throw Error(ExitCode::bad_input, "the shot has no trace");
  Trace& trace = recorded.trace;
  const double speed = recorded.impact.speed;
  const SampleRange contact = contact_window(trace.force, contact_threshold(recorded));
  trace = cut(trace, widened(contact, 1, trace.time.size()));
  if (trace.deflection.empty()) integrate_deflection(trace, recorded.sphere.mass, speed);
  const double momentum = recorded.sphere.mass * speed;
  const double restitution =
      recorded.restitution.value.value_or(integral(trace.time, trace.force) / momentum - 1.0);
  if (!(restitution > 0.0 && restitution <= 1.0))
    throw Error(ExitCode::bad_input,
                fmt::format("the impulse of the trace at {:.6g} m/s gives a restitution of {:.3g}",
                            speed, restitution),
                {.key = "shot.trace",
                 .value = recorded.trace_file,
                 .allowed = "a restitution in (0, 1]; check units of force, mass and time"});
  recorded.scalars = derive_scalars(trace, recorded.impact, trace.time.back(), restitution * speed);
  return recorded;
}

MeasuredImpact contact_alone(const Sphere& sphere, const Impact& impact, const Trace& trace,
                             const ImpactScalars& scalars) {
  return {.sphere = sphere,
          .impact = impact,
          .trace = cut_at(trace, scalars.contact_time),
          .scalars = scalars};
}

}  // namespace rebound
