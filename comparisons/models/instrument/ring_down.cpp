#include "comparisons/models/instrument/ring_down.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "comparisons/models/instrument/sample_step.hpp"

namespace rebound {
namespace {

const std::vector<double>* displacement_of(const Trace& trace) {
  for (const TraceColumn& column : trace.further)
    if (column.name == "plate_displacement_m") return &column.values;
  return nullptr;
}

/// Slope at the last sample, from the parabola through the last three.
double last_slope(const std::vector<double>& t, const std::vector<double>& y) {
  const std::size_t n = t.size();
  const double h1 = t[n - 1] - t[n - 2], h2 = t[n - 2] - t[n - 3];
  const double d1 = (y[n - 1] - y[n - 2]) / h1, d2 = (y[n - 2] - y[n - 3]) / h2;
  return d1 + h1 * (d1 - d2) / (h1 + h2);
}

}  // namespace

Trace with_ring_down(const Trace& contact, const Plate& plate, double duration) {
  const std::vector<double>* y = displacement_of(contact);
  if (!plate.moves() || !y || contact.time.size() < 3) return contact;
  using Complex = std::complex<double>;
  const double omega = std::sqrt(plate.stiffness / plate.mass);
  const double damping = 2.0 * plate.damping_ratio * std::sqrt(plate.stiffness * plate.mass);
  // Both roots of the characteristic equation; complex below critical damping.
  const double zeta = plate.damping_ratio == 1.0 ? 1.0 + 1e-9 : plate.damping_ratio;
  const Complex root = omega * std::sqrt(Complex(zeta * zeta - 1.0));
  const Complex first = -zeta * omega + root, second = -zeta * omega - root;
  const double y0 = y->back(), v0 = last_slope(contact.time, *y);
  const Complex a = (v0 - second * y0) / (first - second), b = y0 - a;

  Trace trace{.time = contact.time, .force = contact.force, .deflection = {}, .further = {}};
  const double end = contact.time.back();
  const double step = sample_step(contact, duration, most_samples_after);
  for (double since = step; since <= duration + step; since += step) {
    const Complex one = a * std::exp(first * since), two = b * std::exp(second * since);
    trace.time.push_back(end + since);
    trace.force.push_back(plate.stiffness * (one + two).real() +
                          damping * (first * one + second * two).real());
  }
  return trace;
}

}  // namespace rebound
