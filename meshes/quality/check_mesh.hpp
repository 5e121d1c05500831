#pragma once

#include <string>

#include "meshes/mesh.hpp"

namespace rebound {

/// Refuses a mesh no tier can use: empty; vertex numbers out of range;
/// coordinates that are not finite, left of the axis or below the plate;
/// inverted or degenerate cells; axis edges off the axis; groups without
/// edges; nothing at the plate.
/// Errors: Error(bad_input) with the reason and `file`.
void check_mesh(const Mesh& mesh, const std::string& file);

}  // namespace rebound
