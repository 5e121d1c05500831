#pragma once

#include <vector>

#include "fem/interface/element_checks.hpp"

namespace rebound::fem {

/// Stretches the cylinder of radius 1 uniformly and reads the stress off the
/// nodal forces of its surface.
///
///   P_rr = Σ_side f_r / (2π L),   P_zz = Σ_end f_z / π
///
///   f internal force on a node of the surface at rest [N], L height [m]
///
/// Time begins at rest, one step before the first stretch; the velocity that a
/// viscous stress asks for is that of the step.
///
/// Limit:  patch test: forces vanish inside, P is the law's -> tests VerificationCaseA;
///         one viscoelastic element -> tests VerificationCaseG
/// Errors: Error(bad_input) for a material these cells do not have.
std::vector<UniformStress> follow_stretches(const Mesh& mesh, CellKind cells,
                                            const Material& material,
                                            const StretchHistory& history);

}  // namespace rebound::fem
