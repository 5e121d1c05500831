#pragma once

#include "meshes/mesh.hpp"

namespace rebound {

/// Radius, length and cell counts of a cylinder standing on the plate.
struct CylinderMesh {
  double radius = 0.0;  ///< [m]
  double length = 0.0;  ///< [m]
  int cells_across = 1;
  int cells_along = 1;
};

/// Structured mesh of a cylinder: axis at r = 0, its lower end in group "contact".
inline Mesh cylinder_mesh(const CylinderMesh& shape) {
  Mesh mesh;
  const auto vertex = [&](int i, int j) { return j * (shape.cells_across + 1) + i; };
  for (int j = 0; j <= shape.cells_along; ++j)
    for (int i = 0; i <= shape.cells_across; ++i)
      mesh.vertices.push_back(
          {shape.radius * i / shape.cells_across, shape.length * j / shape.cells_along});
  for (int j = 0; j < shape.cells_along; ++j) {
    mesh.axis_edges.push_back({vertex(0, j), vertex(0, j + 1)});
    for (int i = 0; i < shape.cells_across; ++i)
      mesh.cells.push_back(
          {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
  }
  for (int i = 0; i < shape.cells_across; ++i)
    mesh.contact_edges.push_back({vertex(i, 0), vertex(i + 1, 0)});
  return mesh;
}

}  // namespace rebound
