#pragma once

#include <array>
#include <vector>

#include "meshes/mesh.hpp"

namespace rebound {

/// The half-section in cells of eight nodes: corners counter-clockwise, then mid-sides.
struct QuadraticSection {
  std::vector<std::array<double, 2>> nodes;       ///< (r, z) [m]; the mesh's vertices first
  std::vector<std::array<int, 8>> cells;          ///< node numbers from 0
  std::vector<std::array<int, 2>> contact_sides;  ///< cell, side: 0 between corners 0 and 1
  double volume = 0.0;                            ///< of the body of revolution [m³]
};

/// Nodes in the middle of every side; on the circle about (0, R) for the sides that may touch
/// the plate and end on it.
/// Limit: volume of a sphere within 1e-5 at 250 cells -> test SectorTest.VolumeOfTheSphere
QuadraticSection quadratic_section(const Mesh& mesh, double radius);

/// A part of the body about the axis z, in bricks of twenty nodes whose sides on the axis have
/// shrunk to a point.
struct Sector {
  std::vector<std::array<double, 3>> nodes;       ///< [m]
  std::vector<std::array<int, 20>> bricks;        ///< 8 corners, 4 + 4 mid-sides, 4 between; from 0
  std::vector<std::array<int, 2>> contact_faces;  ///< brick, side of the section 0 to 3
  std::vector<int> axis;                          ///< nodes at r = 0
  std::vector<int> first_plane, last_plane;       ///< nodes at its smallest and largest angle
};

/// What part: angles from the plane y = 0 [rad], and into how many bricks around.
struct SectorRequest {
  double from = 0.0, to = 0.0;
  int slices = 1;
};

/// Limit: volume (to − from)/2π of the body's -> test SectorTest.VolumeOfTheSphere
Sector sector_of(const QuadraticSection& section, const SectorRequest& request);

}  // namespace rebound
