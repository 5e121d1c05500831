#include "fem/discretisation/discretisation.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_renumbering.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <map>
#include <numbers>
#include <map>
#include <numbers>
#include <set>

#include "lumped/problem/error.hpp"

static_assert(__cplusplus >= 202002L, "deal.II's exported flags must not lower the standard");

namespace rebound::fem {
namespace {

/// deal.II counts corners and Gauss points row by row, the kernel around the cell.
constexpr std::array<int, 4> around = {0, 1, 3, 2};

[[noreturn]] void refuse(const std::string& why) {
  throw Error(ExitCode::bad_input, "mesh refused: " + why, {.key = "model.mesh"});
}

/// What would run and give a wrong answer; deal.II finds the rest.
void check(const Mesh& mesh) {
  if (mesh.cells.empty()) refuse("it has no cells");
  if (mesh.contact_edges.empty()) refuse("it has no edges in the group \"contact\"");
  const auto count = static_cast<int>(mesh.vertices.size());
  std::vector<char> in_cell(count, 0), on_axis(count, 0);
  for (const auto& cell : mesh.cells)
    for (const int vertex : cell) {
      if (vertex < 0 || vertex >= count) refuse("a cell names a vertex that does not exist");
      in_cell[vertex] = 1;
    }
  for (const auto* edges : {&mesh.axis_edges, &mesh.contact_edges})
    for (const auto& edge : *edges)
      for (const int vertex : edge)
        if (vertex < 0 || vertex >= count || !in_cell[vertex]) refuse("an edge belongs to no cell");
  for (const auto& edge : mesh.axis_edges) on_axis[edge[0]] = on_axis[edge[1]] = 1;
  double reach = 0.0;
  for (const auto& v : mesh.vertices) reach = std::max({reach, std::abs(v[0]), std::abs(v[1])});
  for (int i = 0; i < count; ++i) {
    const auto& [r, z] = mesh.vertices[i];
    if (r < 0.0) refuse("a vertex lies at negative radius");
    if (in_cell[i] && (r <= 1e-9 * reach) != (on_axis[i] == 1))
      refuse("the group \"axis\" and the vertices at radius 0 are not the same");
  }
  for (const auto& edge : mesh.contact_edges)
    for (const int vertex : edge)
      if (mesh.vertices[vertex][1] < -1e-9 * reach)
        refuse("a vertex of the group \"contact\" lies below the plate");
}

void triangulate(const Mesh& mesh, dealii::Triangulation<2>& triangulation) {
  std::vector<dealii::Point<2>> vertices;
  vertices.reserve(mesh.vertices.size());
  for (const auto& v : mesh.vertices) vertices.emplace_back(v[0], v[1]);
  std::vector<dealii::CellData<2>> cells;
  cells.reserve(mesh.cells.size());
  for (const auto& c : mesh.cells) {
    dealii::CellData<2> data(4);
    for (int i = 0; i < 4; ++i) data.vertices[around[i]] = static_cast<unsigned>(c[i]);
    cells.push_back(data);
  }
  dealii::GridTools::consistently_order_cells(cells);
  try {
    triangulation.create_triangulation(vertices, cells, {});
  } catch (const dealii::ExceptionBase& error) {
    refuse(std::string("deal.II cannot use it: ") + error.what());
  }
}

CellGeometry geometry_of(const dealii::FEValues<2>& values, const std::vector<unsigned>& dofs) {
  CellGeometry cell;
  for (int i = 0; i < nodes_per_cell; ++i) cell.nodes[i] = static_cast<int>(dofs[around[i]]);
  for (int q = 0; q < points_per_cell; ++q) {
    const auto point = static_cast<unsigned>(around[q]);
    cell.radius[q] = values.quadrature_point(point)[0];
    cell.weight[q] = 2.0 * std::numbers::pi * cell.radius[q] * values.JxW(point);
    for (int i = 0; i < nodes_per_cell; ++i) {
      const auto corner = static_cast<unsigned>(around[i]);
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
    const double third = std::numbers::pi * std::hypot(b[0] - a[0], b[1] - a[1]) / 3.0;
    area[node_of_vertex[first]] += third * (2.0 * a[0] + b[0]);
    area[node_of_vertex[second]] += third * (a[0] + 2.0 * b[0]);
  }
  std::vector<double> areas;
  for (const int node : nodes) areas.push_back(area[node]);
  return areas;
}

}  // namespace

Discretisation discretise(const Mesh& mesh, double mass) {
  check(mesh);
  dealii::Triangulation<2> triangulation;
  triangulate(mesh, triangulation);
  const dealii::FE_Q<2> element(1);
  dealii::DoFHandler<2> dof_handler(triangulation);  // scalar: degree of freedom i is node i
  dof_handler.distribute_dofs(element);
  dealii::DoFRenumbering::Cuthill_McKee(dof_handler, true);

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
      if (!(geometry.weight[q] > 0.0)) refuse("a cell is inverted or has no area");
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
