#pragma once

#include <array>
#include <vector>

#include "fem/implicit/quadratic_shapes.hpp"
#include "lumped/problem/mesh.hpp"

namespace rebound::fem {

/// Geometry of one biquadratic cell at rest, in plain numbers.
struct QuadraticCell {
  struct Point {
    std::array<std::array<double, 2>, quadratic_nodes> gradient{};  ///< ∂N/∂R, ∂N/∂Z [1/m]
    std::array<double, quadratic_nodes> shape{};
    double radius = 0.0;
    double weight = 0.0;  ///< 2π R |J| w [m³]
  };
  std::array<int, quadratic_nodes> nodes{};
  std::array<Point, quadratic_points> points{};
};

/// A contact node and the two nodes behind it, on the way into the body.
struct ContactPlace {
  int node = 0;
  std::array<int, 2> behind{};
};

/// A body of revolution cut into nine-node axisymmetric cells, total Lagrangian.
///
///   ρ = mass / Σ_q 2π R_q |J|_q w_q      so the mass is the mass asked for
///
/// Sides of contact edges whose ends lie on the sphere are curved: their middle
/// node is on it. Shares nothing with `Discretisation`, and needs no deal.II.
struct QuadraticBody {
  std::vector<QuadraticCell> cells;
  std::vector<std::array<double, 2>> position;  ///< at rest, (r, z) [m]
  std::vector<int> axis_nodes;
  std::vector<ContactPlace> contact;            ///< group "contact", ascending radius
  std::vector<std::array<int, 3>> contact_sides; ///< its sides: both ends, the middle
  double mass = 0.0;                            ///< [kg]
  double density = 0.0;                         ///< [kg/m³]
  double height = 0.0;                          ///< of the highest node [m]

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
/// Errors: Error(bad_input) for a mesh without cells or contact group, vertices
///         at negative radius, and cells that are inverted.
QuadraticBody quadratic_body(const Mesh& mesh, const QuadraticRequest& request);

}  // namespace rebound::fem
