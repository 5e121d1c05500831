#pragma once

#include "fem/interface/modules.hpp"
#include "lumped/problem/impact.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound {

/// A ball cut into the cells of `mesh` (mesh_for) once, ready for any number of impacts.
///
/// An interrupted impact throws Error(interrupted), since whoever runs many
/// has no use for a part of one.
/// Errors: those of loading the module, and of FemTier::prepare.
FemRunner fem_runner(const Mesh& mesh, const Sphere& sphere, const RunControl& control);

}  // namespace rebound
