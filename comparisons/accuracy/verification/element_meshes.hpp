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

}  // namespace rebound
