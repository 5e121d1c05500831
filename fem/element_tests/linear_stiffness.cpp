#include "fem/element_tests/linear_stiffness.hpp"

#include <algorithm>

#include "fem/element_tests/bilinear_forces.hpp"
#include "fem/implicit/body_forces.hpp"

namespace rebound::fem {

StiffnessEntries bilinear_stiffness(const Discretisation& body, const Material& material,
                                    double step) {
  BilinearForces forces(body, material, choose_cell_kernel());
  const int size = 2 * body.node_count();
  std::vector<double> u(forces.size(), 0.0);
  StiffnessEntries entries;
  for (int j = 0; j < size; ++j) {
    u[j] = step;
    const std::vector<double> ahead = forces.force(u);
    u[j] = -step;
    const std::vector<double>& behind = forces.force(u);
    u[j] = 0.0;
    for (int i = 0; i < size; ++i)
      if (ahead[i] != behind[i]) entries.emplace_back(i, j, (ahead[i] - behind[i]) / (2.0 * step));
  }
  return entries;
}

LinearBody linear_body(const Mesh& mesh, CellKind cells, const Material& material) {
  double reach = 0.0;
  for (const auto& v : mesh.vertices) reach = std::max({reach, v[0], v[1]});
  if (cells == CellKind::bilinear) {
    Discretisation body = discretise(mesh, 1.0);
    StiffnessEntries entries = bilinear_stiffness(body, material, 1e-6 * reach);
    return {std::move(body.position), std::move(body.axis_nodes), std::move(entries)};
  }
  QuadraticBody body = quadratic_body(mesh, {.mass = 1.0});
  const BodyForces forces(body, material, ContactInertia::kept);
  SystemMatrix stiffness = forces.mass();
  Eigen::VectorXd at_rest;
  forces.linearise(Eigen::VectorXd::Zero(forces.size()), 0.0, at_rest, stiffness);
  LinearBody linear{body.position, body.axis_nodes, {}};
  for (const auto& [row, column, value] : stiffness.entries())
    linear.stiffness.emplace_back(row, column, value);
  return linear;
}

}  // namespace rebound::fem
