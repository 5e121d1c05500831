#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace rebound {

/// An axisymmetric mesh in the (r, z) half-plane: quadrilaterals, and the
/// boundary edges of the named groups. Plate at z = 0, axis at r = 0.
struct Mesh {
  std::vector<std::array<double, 2>> vertices;    ///< (r, z) [m]
  std::vector<std::array<int, 4>> cells;          ///< counter-clockwise vertex numbers
  std::vector<std::array<int, 2>> axis_edges;     ///< group "axis"
  std::vector<std::array<int, 2>> contact_edges;  ///< group "contact": may touch the plate
  /// Of each cell, its place in `region_names`, -1 for none; empty: the mesh has no regions.
  std::vector<int> regions;
  std::vector<std::string> region_names;  ///< physical surfaces
};

/// Which part of a sphere is meshed.
enum class SpherePart {
  whole,
  lower_half  ///< up to the plane z = R
};

/// Half-disc of a sphere resting on the plate, cells graded to the contact.
struct SphereMeshRequest {
  double radius = 0.0;   ///< [m]
  int cells = 1000;      ///< about
  double grading = 1.5;  ///< cell size opposite the pole over that at it, >= 1
  SpherePart part = SpherePart::whole;
};

/// Shape figures of a mesh; the solver refuses a mesh whose worst Jacobian is not positive.
struct MeshQuality {
  int cells = 0;
  int vertices = 0;
  double smallest_edge = 0.0;          ///< [m]
  double largest_edge = 0.0;           ///< [m]
  double worst_scaled_jacobian = 0.0;  ///< 1 for a rectangle, <= 0 inverted
  double volume = 0.0;                 ///< of the body of revolution [m³]
  double contact_edge_length = 0.0;    ///< mean length of contact edges near the plate [m]
};

}  // namespace rebound
