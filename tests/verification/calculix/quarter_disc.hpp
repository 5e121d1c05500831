#pragma once

#include <array>
#include <vector>

namespace rebound::calculix {

/// Eight-node quadrilaterals, corners counter-clockwise and then mid-sides.
struct QuadraticMesh {
  std::vector<std::array<double, 2>> nodes;  ///< (r, z) [m]
  std::vector<std::array<int, 8>> elements;  ///< from 0

  /// The node at a place, made where there is none.
  int node_at(const std::array<double, 2>& place);

 private:
  std::vector<std::pair<std::array<long, 2>, int>> places_;  ///< sorted
};

/// The lower half of a sphere resting on z = 0: three blocks, `fineness` cells
/// along the axis, twice as many along the contact and to the surface, four to
/// five times smaller there. Shares nothing with meshes/.
QuadraticMesh lower_half(double radius, int fineness);

/// The lower half and its image in the plane z = radius.
QuadraticMesh whole_sphere(double radius, int fineness);

/// A rectangle r from 0 to `width`, z from −`height` to 0, in one row of cells.
QuadraticMesh plate(double width, double height, int cells);

}  // namespace rebound::calculix
