#pragma once

#include <vector>

#include "fem/discretisation/discretisation.hpp"

namespace rebound::fem {

/// What the plate did to the body over one step.
struct PlateStep {
  double impulse = 0.0;          ///< on the body, away from the plate [N s]
  double constraint_work = 0.0;  ///< done on the body, ≤ 0 [J]
  double contact_radius = 0.0;   ///< largest radius of a node in contact; 0: none [m]
};

/// Time span of one central-difference step.
struct StepSpan {
  double kick = 0.0;   ///< ½ (Δtₙ₋₁ + Δtₙ): over which forces change velocity [s]
  double drift = 0.0;  ///< Δtₙ: over which velocity changes position [s]
};

/// Rigid frictionless plate at z = 0, unilateral, acting on nodes.
///
/// A node that the drift would carry below the plate gets the velocity that
/// places it on the plate; the impulse is what that takes:
///
///   v' = −z/Δt,    I = m (v' − v),    work = I (v_before + v')/2
///
///   v_before  velocity half a step earlier [m/s]
///
/// The force is zero unless the node would penetrate, so the plate can only
/// push. Catching a moving node is a plastic impact of its lumped mass: the
/// energy lost is booked as constraint work, and vanishes with the cell size
/// -> test ImpactConvergence.ConstraintWorkFalls.
/// Caution: force is resolved to one node spacing of the contact front; the
///          trace carries a ripple that falls with the cell size.
/// Source:  Hallquist, Goudreau & Benson, Comput. Methods Appl. Mech. Engrg.
///          51 (1985) 107–137, kinematic constraint.
class RigidPlate {
 public:
  explicit RigidPlate(const Discretisation& body);

  /// Keeps the velocities that the step's forces are about to change.
  void remember(const std::vector<double>& velocity);

  /// Corrects `velocity` of the nodes that would penetrate. Displacement and
  /// velocity are [node][2] (r, z).
  PlateStep hold_back(const std::vector<double>& displacement, std::vector<double>& velocity,
                      const StepSpan& span) const;

  /// Smallest height above the plate of a node that may touch [m].
  double gap(const std::vector<double>& displacement) const;

 private:
  struct ContactNode {
    int node;
    double r, z, mass;
  };
  std::vector<ContactNode> nodes_;
  std::vector<double> velocity_before_;
};

}  // namespace rebound::fem
