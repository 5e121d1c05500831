#pragma once

#include "fem/interface/element_checks.hpp"
#include "meshes/mesh.hpp"

namespace rebound::fem {

/// A body at rest in linear elasticity, on either kind of cells, sides straight.
///
///   K₀ u = f,   u where it is given, f = 0 elsewhere
///   under an indenter:  u_z ≤ w,  f_z ≤ 0,  f_z (u_z − w) = 0   for every node it names
///
/// K₀ is the tangent at rest of the cells that impacts use, mean dilatation included.
///
/// Limit:  uniform pressing of a block to rounding -> rows "nearly incompressible" of
///         `rebound verify`, test VerificationRubber
/// Errors: Error(solver_failed) where K₀ has no factors or the contact does not settle.
LinearAnswer linear_statics(const Mesh& mesh, CellKind cells, const LinearStatics& problem);

}  // namespace rebound::fem
