#pragma once

#include <array>

#include "fem/interface/element_checks.hpp"
#include "meshes/mesh.hpp"

namespace rebound {

inline constexpr std::array cell_kinds = {CellKind::bilinear, CellKind::nine_node};

constexpr const char* name_of(CellKind cells) {
  return cells == CellKind::bilinear ? "bilinear" : "nine-node";
}

/// The cylinder of radius and height 1 in n × n cells, bent inside by up to 0.06.
Mesh bent_cylinder(int n);

/// The cylinder of radius 1 and height 1.2 in 4 × 5 cells, inner vertices moved
/// by up to a fifth of a cell, always the same way.
Mesh distorted_cylinder();

/// The quarter z >= 0, around the origin, of a hollow sphere; "contact" is its inner surface. Twice
/// as many cells around as across.
Mesh quarter_of_thick_sphere(double inner, double outer, int cells_around);

/// A layer on z = 0 with even cells of `finest` where a ball of radius 1 would touch, growing
/// outwards and downwards.
struct LayerMesh {
  double height = 1.0, width = 1.0;  ///< [m]
  double finest = 0.1;               ///< [m]
};
Mesh layer_mesh(const LayerMesh& layer);

}  // namespace rebound
