#pragma once

#include "meshes/generate/cylinder_mesh.hpp"

namespace rebound::test {

/// Structured mesh of a cylinder standing on the plate.
inline Mesh cylinder(const CylinderMesh& shape) {
  return cylinder_mesh(shape);
}

}  // namespace rebound::test
