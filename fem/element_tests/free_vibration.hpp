#pragma once

#include "fem/interface/element_checks.hpp"

namespace rebound::fem {

/// Lowest axisymmetric frequencies of the elastic sphere that touches z = 0.
///
///   K x = ω² M x,   u_r = 0 on the axis, free otherwise
///
///   K  stiffness at rest [N/m]: of the tangent (nine-node), of central
///      differences of the forces (bilinear, which has no tangent)
///   M  mass [kg]: consistent (nine-node), lumped (bilinear)
///
/// by subspace iteration with K + (2π 100 Hz)² M, so that the rigid motion does
/// no harm. The dispersion correction of the explicit scheme is not part of K.
///
/// Limit:  Lamb's frequencies -> tests VerificationCaseB
/// Errors: Error(solver_failed) where the iteration does not converge.
FreeVibration free_vibration(const Mesh& mesh, CellKind cells, VibratingMass mass,
                             const VibratingSphere& sphere);

}  // namespace rebound::fem
