#include "fem/discretisation/discretisation.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q1.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "fem/discretisation/edge_area.hpp"
#include "fem/discretisation/node_order.hpp"
#include "fem/discretisation/triangulation.hpp"

static_assert(__cplusplus >= 202002L, "deal.II's exported flags must not lower the standard");

namespace rebound::fem {
namespace {

CellGeometry geometry_of(const dealii::FEValues<2>& values, const std::vector<unsigned>& dofs) {
  CellGeometry cell;
  for (int i = 0; i < nodes_per_cell; ++i)
    cell.nodes[i] = static_cast<int>(dofs[corners_around[i]]);
  for (int q = 0; q < points_per_cell; ++q) {
    const auto point = static_cast<unsigned>(corners_around[q]);
    cell.radius[q] = values.quadrature_point(point)[0];
    cell.weight[q] = 2.0 * std::numbers::pi * cell.radius[q] * values.JxW(point);
    for (int i = 0; i < nodes_per_cell; ++i) {
      const auto corner = static_cast<unsigned>(corners_around[i]);
      cell.shape[q][i] = values.shape_value(corner, point);
      cell.gradient[q][i] = {values.shape_grad(corner, point)[0],
                             values.shape_grad(corner, point)[1]};
    }
  }
  return cell;
}

std::vector<int> nodes_of(const std::vector<std::array<int, 2>>& edges,
                          const std::vector<int>& node_of_vertex) {
  std::set<int> nodes;
  for (const auto& edge : edges)
    for (const int vertex : edge) nodes.insert(node_of_vertex[vertex]);
  return {nodes.begin(), nodes.end()};
}

/// ∮ 2πR N ds of each of `nodes` along the contact edges.
std::vector<double> areas_of(const std::vector<int>& nodes, const Mesh& mesh,
                             const std::vector<int>& node_of_vertex) {
  std::map<int, double> area;
  for (const auto& [first, second] : mesh.contact_edges) {
    const auto& a = mesh.vertices[static_cast<std::size_t>(first)];
    const auto& b = mesh.vertices[static_cast<std::size_t>(second)];
    const auto [at_first, at_second] = edge_areas(a, b);
    area[node_of_vertex[first]] += at_first;
    area[node_of_vertex[second]] += at_second;
  }
  std::vector<double> areas;
  areas.reserve(nodes.size());
  for (const int node : nodes) areas.push_back(area[node]);
  return areas;
}

}  // namespace

Discretisation discretise(const Mesh& mesh, double mass) {
  dealii::Triangulation<2> triangulation;
  triangulate(mesh, triangulation);
  const dealii::FE_Q<2> element(1);
  dealii::DoFHandler<2> dof_handler(triangulation);  // scalar: degree of freedom i is node i
  dof_handler.distribute_dofs(element);
  number_nodes(dof_handler);

  Discretisation body;
  const auto count = dof_handler.n_dofs();
  body.position.resize(count);
  body.mass.assign(count, 0.0);
  std::vector<int> node_of_vertex(mesh.vertices.size(), -1);

  dealii::FEValues<2> values(element, dealii::QGauss<2>(2),
                             dealii::update_values | dealii::update_gradients |
                                 dealii::update_quadrature_points | dealii::update_JxW_values);
  std::vector<unsigned> dofs(nodes_per_cell);
  double volume = 0.0;
  for (const auto& cell : dof_handler.active_cell_iterators()) {
    values.reinit(cell);
    cell->get_dof_indices(dofs);
    for (unsigned corner = 0; corner < 4; ++corner) {
      body.position[dofs[corner]] = {cell->vertex(corner)[0], cell->vertex(corner)[1]};
      node_of_vertex[cell->vertex_index(corner)] = static_cast<int>(dofs[corner]);
    }
    const CellGeometry geometry = geometry_of(values, dofs);
    for (int q = 0; q < points_per_cell; ++q) {
      if (!(geometry.weight[q] > 0.0)) refuse_mesh("a cell is inverted or has no area");
      volume += geometry.weight[q];
      for (int i = 0; i < nodes_per_cell; ++i)
        body.mass[geometry.nodes[i]] += geometry.weight[q] * geometry.shape[q][i];
    }
    body.cells.push_back(geometry);
  }
  body.density = mass / volume;
  for (double& m : body.mass) m *= body.density;
  body.axis_nodes = nodes_of(mesh.axis_edges, node_of_vertex);
  body.contact_nodes = nodes_of(mesh.contact_edges, node_of_vertex);
  std::sort(body.contact_nodes.begin(), body.contact_nodes.end(),
            [&](int a, int b) { return body.position[a] < body.position[b]; });
  body.contact_area = areas_of(body.contact_nodes, mesh, node_of_vertex);
  return body;
}

}  // namespace rebound::fem
