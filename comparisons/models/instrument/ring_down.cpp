#include "comparisons/models/instrument/ring_down.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <complex>
#include <functional>

#include "comparisons/models/instrument/sample_step.hpp"
#include "lumped/mechanisms/moving_plate.hpp"

namespace rebound {
namespace {

using Complex = std::complex<double>;
/// What the load cell reads, over the time since the ball left.
using Reading = std::function<double(double since)>;

const std::vector<double>* displacement_of(const Trace& trace, const char* what) {
  for (const TraceColumn& column : trace.further)
    if (column.name == what) return &column.values;
  return nullptr;
}

/// Slope at the last sample, from the parabola through the last three.
double last_slope(const std::vector<double>& t, const std::vector<double>& y) {
  const std::size_t n = t.size();
  const double h1 = t[n - 1] - t[n - 2], h2 = t[n - 2] - t[n - 3];
  const double d1 = (y[n - 1] - y[n - 2]) / h1, d2 = (y[n - 2] - y[n - 3]) / h2;
  return d1 + h1 * (d1 - d2) / (h1 + h2);
}

Reading reading_of_plate(const Plate& plate, double y0, double v0) {
  const double omega = std::sqrt(plate.stiffness / plate.mass);
  const double damping = 2.0 * plate.damping_ratio * std::sqrt(plate.stiffness * plate.mass);
  // Both roots of the characteristic equation; complex below critical damping.
  const double zeta = plate.damping_ratio == 1.0 ? 1.0 + 1e-9 : plate.damping_ratio;
  const Complex root = omega * std::sqrt(Complex(zeta * zeta - 1.0));
  const Complex first = -zeta * omega + root, second = -zeta * omega - root;
  const Complex a = (v0 - second * y0) / (first - second), b = y0 - a;
  return [=, k = plate.stiffness](double since) {
    const Complex one = a * std::exp(first * since), two = b * std::exp(second * since);
    return k * (one + two).real() + damping * (first * one + second * two).real();
  };
}

/// Plate and frame in their four modes; `start` is y, ẏ, z, ż.
Reading reading_of_plate_on_frame(const Plate& plate, const Eigen::Vector4d& start) {
  const double k = plate.stiffness, c = plate_damping(plate), m = plate.mass;
  const double k_f = plate.frame.stiffness, c_f = frame_damping(plate.frame),
               m_f = plate.frame.mass;
  const Eigen::RowVector4d cell(k, c, -k, -c);
  Eigen::Matrix4d rate;
  rate << 0.0, 1.0, 0.0, 0.0, -cell / m, 0.0, 0.0, 0.0, 1.0, cell / m_f;
  rate.row(3) -= Eigen::RowVector4d(0.0, 0.0, k_f / m_f, c_f / m_f);
  const Eigen::EigenSolver<Eigen::Matrix4d> modes(rate);
  const Eigen::Vector4cd& rates = modes.eigenvalues();
  const Eigen::Vector4cd shares = modes.eigenvectors().partialPivLu().solve(start.cast<Complex>());
  const Eigen::Vector4cd amplitudes =
      (cell.cast<Complex>() * modes.eigenvectors()).transpose().cwiseProduct(shares);
  return [=](double since) {
    return amplitudes.cwiseProduct((rates * since).array().exp().matrix()).sum().real();
  };
}

}  // namespace

Trace with_ring_down(const Trace& contact, const Plate& plate, double duration) {
  const std::vector<double>* y = displacement_of(contact, "plate_displacement_m");
  const std::vector<double>* z = displacement_of(contact, "frame_displacement_m");
  if (!plate.moves() || !y || contact.time.size() < 3) return contact;
  const double y0 = y->back(), v0 = last_slope(contact.time, *y);
  const Reading reading =
      plate.frame.moves() && z
          ? reading_of_plate_on_frame(plate, {y0, v0, z->back(), last_slope(contact.time, *z)})
          : reading_of_plate(plate, y0, v0);

  Trace trace{.time = contact.time, .force = contact.force, .deflection = {}, .further = {}};
  const double end = contact.time.back();
  const double step = sample_step(contact, duration, most_samples_after);
  for (double since = step; since <= duration + step; since += step) {
    trace.time.push_back(end + since);
    trace.force.push_back(reading(since));
  }
  return trace;
}

}  // namespace rebound
