#include "comparisons/accuracy/verification/element_meshes.hpp"

#include <cmath>
#include <numbers>

#include "meshes/generate/cylinder_mesh.hpp"

namespace rebound {

Mesh bent_cylinder(int n) {
  Mesh mesh = cylinder_mesh({.radius = 1.0, .length = 1.0, .cells_across = n, .cells_along = n});
  for (auto& [r, z] : mesh.vertices) {
    const double bend = 0.06 * std::sin(std::numbers::pi * r) * std::sin(std::numbers::pi * z);
    r += bend;
    z -= bend;
  }
  return mesh;
}

Mesh distorted_cylinder() {
  constexpr int across = 4, along = 5;
  Mesh mesh =
      cylinder_mesh({.radius = 1.0, .length = 1.2, .cells_across = across, .cells_along = along});
  for (int j = 1; j < along; ++j)
    for (int i = 1; i < across; ++i) {
      const int vertex = j * (across + 1) + i;
      mesh.vertices[vertex][0] += 0.05 * std::sin(5.0 * vertex);
      mesh.vertices[vertex][1] += 0.05 * std::cos(7.0 * vertex);
    }
  return mesh;
}

}  // namespace rebound
