#pragma once

#include <array>
#include <vector>

#include "meshes/mesh.hpp"

namespace rebound::fem {

inline constexpr int quadratic_nodes = 9;   ///< corners, mid-sides, centre
inline constexpr int quadratic_points = 9;  ///< 3×3 Gauss points

/// Geometry of one biquadratic cell at rest, in plain numbers.
struct QuadraticCell {
  struct Point {
    std::array<std::array<double, 2>, quadratic_nodes> gradient{};  ///< ∂N/∂R, ∂N/∂Z [1/m]
    std::array<double, quadratic_nodes> shape{};
    double radius = 0.0;
    double weight = 0.0;  ///< 2π R |J| w [m³]
  };
  /// Corners counter-clockwise, the middles of the sides that follow them, the centre.
  std::array<int, quadratic_nodes> nodes{};
  std::array<Point, quadratic_points> points{};
};

/// A contact node and the two nodes behind it, on the way into the body.
struct ContactPlace {
  int node = 0;
  std::array<int, 2> behind{};
};

/// A side of the contact group, with its three Gauss points.
struct ContactSide {
  struct Point {
    std::array<double, 3> shape{};
    double height = 0.0;  ///< [m]
    double area = 0.0;    ///< 2π R ds [m²]
  };
  std::array<int, 3> nodes{};  ///< both ends, the middle
  std::array<Point, 3> points{};
};

/// A body of revolution cut into deal.II's FE_Q(2) cells, axisymmetric, total Lagrangian.
///
///   ρ = mass / Σ_q 2π R_q |J|_q w_q      so the mass is the mass asked for
///
/// Sides of contact edges whose ends lie on the sphere are curved: their middle node is on
/// it (SphericalManifold), and the mapping is of second degree. deal.II is asked once; what
/// follows sees plain numbers.
struct QuadraticBody {
  std::vector<QuadraticCell> cells;
  std::vector<std::array<double, 2>> position;  ///< at rest, (r, z) [m]
  std::vector<int> axis_nodes;
  std::vector<ContactPlace> contact;  ///< group "contact", ascending radius
  std::vector<ContactSide> contact_sides;
  double mass = 0.0;     ///< [kg]
  double density = 0.0;  ///< [kg/m³]
  double height = 0.0;   ///< of the highest node [m]

  int node_count() const { return static_cast<int>(position.size()); }
};

/// Radius of the sphere that curves its sides, and the mass of the body.
struct QuadraticRequest {
  double radius = 0.0;  ///< of the sphere resting on the plate; 0: all sides straight [m]
  double mass = 0.0;    ///< [kg]
};

/// Builds the body of `mesh`.
///
/// Limit:  volume of a sphere converges in fourth order of the cell size
///         -> test QuadraticBodyTest.VolumeOfTheSphere
/// Errors: Error(bad_input) as triangulate(), and for cells that are inverted.
QuadraticBody quadratic_body(const Mesh& mesh, const QuadraticRequest& request);

}  // namespace rebound::fem
