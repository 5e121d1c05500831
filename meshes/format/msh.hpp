#pragma once

#include <string>
#include <string_view>

#include "lumped/problem/mesh.hpp"

namespace rebound {

/// A mesh as Gmsh MSH 2.2 ASCII with x = r and y = z, coordinates that read
/// back to the same bits, and the physical groups 1 "axis" and 2 "contact" (lines) and 3 "sphere" (quadrilaterals).
std::string write_msh(const Mesh& mesh);

/// Reads MSH 2.2 or 4.1 ASCII and checks it with check_mesh().
///
/// Edges come from the groups named "axis" and "contact"; all quadrilaterals
/// are taken; points, further groups and nodes of no cell are passed over.
/// Errors: Error(bad_input) naming `file` and, where there is one, the line:
/// no mesh, binary, another version, truncated, triangles, nodes off the
/// plane, unlabelled, or anything check_mesh() refuses.
Mesh read_msh(std::string_view text, const std::string& file);

}  // namespace rebound
