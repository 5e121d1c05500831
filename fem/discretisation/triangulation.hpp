#pragma once

#include <deal.II/grid/tria.h>

#include <string>

#include "meshes/mesh.hpp"

namespace rebound::fem {

/// Number of the group "contact" in a triangulation.
inline constexpr dealii::types::boundary_id contact_boundary = 1;

/// The corners of deal.II's cell, which it counts row by row, in the order around it.
inline constexpr int corners_around[4] = {0, 1, 3, 2};

/// Makes deal.II's triangulation of `mesh`, cells in its order.
///
/// Errors: Error(bad_input) for a mesh without cells or contact group, vertices at
///         r < 0, a contact group below the plate or inside the body, an axis group that
///         is not exactly the vertices at r = 0, numbers of vertices that do not exist.
void triangulate(const Mesh& mesh, dealii::Triangulation<2>& triangulation);

/// Throws Error(bad_input) that says why a mesh is refused.
[[noreturn]] void refuse_mesh(const std::string& why);

}  // namespace rebound::fem
