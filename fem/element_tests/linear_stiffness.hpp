#pragma once

#include <Eigen/SparseCore>
#include <array>
#include <vector>

#include "fem/discretisation/discretisation.hpp"
#include "fem/interface/element_checks.hpp"

namespace rebound::fem {

using StiffnessEntries = std::vector<Eigen::Triplet<double>>;

/// ∂f/∂u at rest of the explicit kernel's cells, all unknowns [node][r, z], by central differences
/// of the nodal forces over ± `step` [m].
StiffnessEntries bilinear_stiffness(const Discretisation& body, const Material& material,
                                    double step);

/// A body whose cells stay linear.
struct LinearBody {
  std::vector<std::array<double, 2>> position;  ///< [m]
  std::vector<int> axis_nodes;
  StiffnessEntries stiffness;  ///< both triangles [N/m]
};

/// Of either kind of cells; sides are straight.
LinearBody linear_body(const Mesh& mesh, CellKind cells, const Material& material);

}  // namespace rebound::fem
