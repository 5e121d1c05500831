#pragma once

#include <string>

#include "meshes/mesh.hpp"

namespace rebound {

/// Where the coordinates of Gmsh's present model come from.
enum class Coordinates {
  given,    ///< read as they stand, to be refused where they are wrong
  computed  ///< by a geometry kernel: its rounding is taken off axis, plate and plane
};

/// The mesh of Gmsh's present model: physical curves "axis" and "contact", all quadrilaterals,
/// their regions; vertices and cells in the order of their tags, vertices of no cell left out.
///
/// Errors: Error(bad_input) naming `file`: triangles, cells of second order or of three dimensions,
/// nodes
///         off the plane.
Mesh collect_mesh(const std::string& file, Coordinates coordinates);

}  // namespace rebound
