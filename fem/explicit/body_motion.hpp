#pragma once

#include <vector>

#include "fem/discretisation/discretisation.hpp"
#include "fem/explicit/dispersion_correction.hpp"

namespace rebound::fem {

/// Displacement, velocity and internal force of every node, [node][2] (r, z),
/// with the sums over them that energy and momentum need. Mass is lumped, with
/// a DispersionCorrection.
class BodyMotion {
 public:
  /// All nodes at `approach` towards the plate [m/s]; nodes of the axis stay on it.
  BodyMotion(const Discretisation& body, double approach, DispersionCorrection dispersion);

  double kinetic() const;   ///< [J]
  double momentum() const;  ///< away from the plate [kg m/s]
  bool is_finite() const;   ///< all velocities

  /// Velocities belong to half steps: what belongs to the instant between two.
  struct Means {
    double kinetic = 0.0;       ///< [J]
    double momentum = 0.0;      ///< [kg m/s]
    double momentum_now = 0.0;  ///< of the later alone [kg m/s]
  };
  /// `before`: the velocities half a step before that instant, those of now half a step after.
  Means means_since(const std::vector<double>& before) const;

  /// Velocities by the internal forces and gravity over `span`.
  void kick(double span, double gravity);
  void drift(double span);

  /// Mean of u_z by mass [m].
  double mean_height() const;
  double total_mass() const { return total_mass_; }

  std::vector<double> displacement, velocity, force;

 private:
  const Discretisation& body_;
  std::vector<double> mass_, inverse_mass_;  ///< [node][2]
  DispersionCorrection dispersion_;
  double total_mass_ = 0.0;
};

}  // namespace rebound::fem
