#pragma once

#include <array>
#include <string>
#include <vector>

#include "fem/interface/fem_problem.hpp"
#include "fem/kernel/cell_kernel.hpp"
#include "fem/materials/viscoelastic_constants.hpp"
#include "meshes/mesh.hpp"

namespace rebound::fem {

/// Nodes that follow each other in number, and that sums over neighbours take at once.
inline constexpr int nodes_per_block = 4;

/// Geometry of one cell in plain numbers: gradients of the shape functions at
/// rest, counted counter-clockwise, at four Gauss points.
struct CellGeometry {
  std::array<int, nodes_per_cell> nodes{};
  std::array<std::array<std::array<double, 2>, nodes_per_cell>, points_per_cell> gradient{};
  std::array<std::array<double, nodes_per_cell>, points_per_cell> shape{};
  std::array<double, points_per_cell> radius{};
  std::array<double, points_per_cell> weight{};  ///< 2π R |J| w [m³]
};

/// A sphere (or any body of revolution) cut into bilinear axisymmetric cells,
/// total Lagrangian, lumped mass.
///
///   mass_i = Σ_q ρ N_i(q) 2π R_q |J|_q w_q,   ρ = mass / Σ_q weight_q
///
/// so the discrete body has exactly the mass asked for whatever the mesh.
/// Nodes are ordered for locality (node_order.hpp).
struct Discretisation {
  std::vector<CellGeometry> cells;
  std::vector<std::array<double, 2>> position;  ///< at rest, (r, z) [m]
  std::vector<double> mass;                     ///< per node [kg]
  std::vector<int> axis_nodes;
  std::vector<int> contact_nodes;    ///< ascending radius
  std::vector<double> contact_area;  ///< ∮ 2πR N ds at rest, per contact node [m²]
  double density = 0.0;              ///< [kg/m³]

  int node_count() const { return static_cast<int>(position.size()); }
};

/// Builds the discretisation of `mesh` for a body of the given mass.
/// Errors: Error(bad_input) for inverted cells, vertices at r < 0, an empty
///         contact group or one below the plate, an axis group that is not
///         exactly the vertices at r = 0, numbers of vertices that do not exist.
Discretisation discretise(const Mesh& mesh, double mass);

using PointFactors = std::vector<std::array<double, points_per_cell>>;

/// What a cell's stiffness depends on beside its moduli.
struct CellStiffness {
  PointFactors factors = {};     ///< of the moduli, by cell and point; empty: one everywhere
  bool mean_dilatation = false;  ///< all points have the volume ratio of the cell
};

/// Largest eigenfrequency squared of each cell alone, small strain, lumped
/// mass: a bound of the assembled one (Irons & Treharne 1971) [1/s²].
std::vector<double> cell_frequencies(const Discretisation& body, const Moduli& moduli,
                                     const CellStiffness& cells = {});

}  // namespace rebound::fem
