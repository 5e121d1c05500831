#pragma once

#include "lumped/problem/impact.hpp"
#include "lumped/problem/modules.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound {

/// A sphere cut into about `cells` cells once, ready for any number of impacts.
///
/// An interrupted impact throws Error(interrupted), since whoever runs many
/// has no use for a part of one.
/// Errors: those of the mesh, of loading the modules, and of FemTier::prepare.
FemRunner fem_runner(const Sphere& sphere, int cells, const RunControl& control);

}  // namespace rebound
