#include "fem/explicit/body_motion.hpp"

#include <cmath>
#include <utility>

#include "fem/explicit/node_passes.hpp"

namespace rebound::fem {

BodyMotion::BodyMotion(const Discretisation& body, double approach, DispersionCorrection dispersion)
    : body_(body), dispersion_(std::move(dispersion)) {
  // Unused nodes behind: the first for padding lanes, all for blocks of the correction.
  const std::size_t size = 2 * (body.position.size() + NodeLaplacian::padding);
  displacement.assign(size, 0.0);
  velocity.assign(size, 0.0);
  force.assign(size, 0.0);
  mass_.assign(size, 0.0);
  inverse_mass_.assign(size, 0.0);
  for (int node = 0; node < body.node_count(); ++node) {
    mass_[2 * node] = mass_[2 * node + 1] = body.mass[node];
    inverse_mass_[2 * node] = inverse_mass_[2 * node + 1] = 1.0 / body.mass[node];
    velocity[2 * node + 1] = -approach;
    total_mass_ += body.mass[node];
  }
  for (const int node : body.axis_nodes) inverse_mass_[2 * node] = 0.0;
}

double BodyMotion::kinetic() const {
  return 0.5 * weighted_sums(mass_, velocity).squares -
         dispersion_.mean_kinetic(velocity, velocity);
}

double BodyMotion::momentum() const {
  return weighted_sums(mass_, velocity).axial;
}

bool BodyMotion::is_finite() const {
  return std::isfinite(weighted_sums(mass_, velocity).squares);
}

BodyMotion::Means BodyMotion::means_since(const std::vector<double>& before) const {
  const WeightedSums then = weighted_sums(mass_, before), now = weighted_sums(mass_, velocity);
  return {
      .kinetic = 0.25 * (then.squares + now.squares) - dispersion_.mean_kinetic(before, velocity),
      .momentum = 0.5 * (then.axial + now.axial),
      .momentum_now = now.axial};
}

void BodyMotion::kick(double span, double gravity) {
  dispersion_.kick(span, inverse_mass_, force, velocity);
  if (gravity == 0.0) return;
  for (int node = 0; node < body_.node_count(); ++node) velocity[2 * node + 1] -= span * gravity;
}

void BodyMotion::drift(double span) {
  add_scaled(displacement, span, velocity);
}

double BodyMotion::mean_height() const {
  return weighted_sums(mass_, displacement).axial / total_mass_;
}

}  // namespace rebound::fem
