#pragma once

#include <array>

#include "fem/interface/element_checks.hpp"
#include "meshes/mesh.hpp"

namespace rebound::fem {

/// A manufactured axisymmetric solution at finite strain on the cylinder of
/// radius 1 and height 1, points next to the axis included.
///
///   u_r = 0.1 R cos Z + 0.05 R³,   u_z = 0.1 sin Z (1 − R²)
///   neo-Hookean, μ = 1 Pa, λ = 4 Pa;   −Div P = B inside, u given on the surface
///
/// B [N/m³] comes from the stress by forward differentiation.
/// Limit:  B at five points -> test VerificationCaseA.BodyForceOfTheManufacturedSolution
std::array<double, 2> manufactured_body_force(double r, double z);

/// Solves for u on `mesh` by Newton's method and measures it against the above,
/// at the integration points. The explicit kernel has no tangent: one of
/// differences serves.
///
/// Limit:  orders in L2/H1: bilinear 2/1, nine-node 3/2 -> tests VerificationCaseA
/// Errors: Error(solver_failed) where Newton's method does not converge.
FieldError manufactured_error(const Mesh& mesh, CellKind cells);

}  // namespace rebound::fem
