#include "fem/explicit/body_motion.hpp"

#include <utility>

namespace rebound::fem {

BodyMotion::BodyMotion(const Discretisation& body, double approach, DispersionCorrection dispersion)
    : body_(body), dispersion_(std::move(dispersion)) {
  const std::size_t size = 2 * (body.position.size() + 1);  // one unused node for padding lanes
  displacement.assign(size, 0.0);
  velocity.assign(size, 0.0);
  force.assign(size, 0.0);
  inverse_mass_.assign(size, 0.0);
  for (int node = 0; node < body.node_count(); ++node) {
    inverse_mass_[2 * node] = inverse_mass_[2 * node + 1] = 1.0 / body.mass[node];
    velocity[2 * node + 1] = -approach;
    total_mass_ += body.mass[node];
  }
  for (const int node : body.axis_nodes) inverse_mass_[2 * node] = 0.0;
}

BodyMotion::Sums BodyMotion::sums() const {
  double radial = 0.0, axial = 0.0, momentum = 0.0;
  for (int node = 0; node < body_.node_count(); ++node) {
    const double m = body_.mass[node];
    const double vr = velocity[2 * node];
    const double vz = velocity[2 * node + 1];
    radial += m * vr * vr;
    axial += m * vz * vz;
    momentum += m * vz;
  }
  return {.kinetic = 0.5 * (radial + axial) - dispersion_.kinetic(velocity), .momentum = momentum};
}

void BodyMotion::kick(double span, double gravity) {
  dispersion_.kick(span, inverse_mass_, force, velocity);
  if (gravity == 0.0) return;
  for (int node = 0; node < body_.node_count(); ++node) velocity[2 * node + 1] -= span * gravity;
}

void BodyMotion::drift(double span) {
  for (std::size_t i = 0; i < displacement.size(); ++i) displacement[i] += span * velocity[i];
}

double BodyMotion::mean_height() const {
  double sum = 0.0;
  for (int node = 0; node < body_.node_count(); ++node)
    sum += body_.mass[node] * displacement[2 * node + 1];
  return sum / total_mass_;
}

}  // namespace rebound::fem
