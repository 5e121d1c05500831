#pragma once

#include "fem/contact/plate_contact.hpp"

namespace rebound::fem {

/// Rigid plate at z = 0, unilateral, acting on nodes.
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
/// energy lost is counted as constraint work, and vanishes with the cell size
/// -> test ImpactConvergence.ConstraintWorkFalls.
/// Caution: force is resolved to one node spacing of the contact front; the
///          trace carries a ripple that falls with the cell size.
/// Source:  Hallquist, Goudreau & Benson, Comput. Methods Appl. Mech. Engrg.
///          51 (1985) 107–137, kinematic constraint.
class RigidPlate final : public PlateContact {
 public:
  using PlateContact::PlateContact;

  PlateStep apply_contact(const std::vector<double>& displacement, std::vector<double>& velocity,
                          const StepSpan& span) override;

  /// Clear when it moves away and its gap exceeds its vibration.
  bool is_clear_of(const std::vector<double>& displacement, const Departure& body) const override;
};

}  // namespace rebound::fem
