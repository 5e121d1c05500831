#include "fem/discretisation/triangulation.hpp"

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "lumped/problem/error.hpp"

namespace rebound::fem {

void refuse_mesh(const std::string& why) {
  throw Error(ExitCode::bad_input, "mesh refused: " + why, {.key = "model.mesh"});
}

namespace {

/// What would run and give a wrong answer; deal.II finds the rest.
void check(const Mesh& mesh) {
  if (mesh.cells.empty()) refuse_mesh("it has no cells");
  if (mesh.contact_edges.empty()) refuse_mesh("it has no edges in the group \"contact\"");
  const auto count = static_cast<int>(mesh.vertices.size());
  std::vector<char> in_cell(count, 0), on_axis(count, 0);
  for (const auto& cell : mesh.cells)
    for (const int vertex : cell) {
      if (vertex < 0 || vertex >= count) refuse_mesh("a cell names a vertex that does not exist");
      in_cell[vertex] = 1;
    }
  for (const auto* edges : {&mesh.axis_edges, &mesh.contact_edges})
    for (const auto& edge : *edges)
      for (const int vertex : edge)
        if (vertex < 0 || vertex >= count || !in_cell[vertex])
          refuse_mesh("an edge belongs to no cell");
  for (const auto& edge : mesh.axis_edges) on_axis[edge[0]] = on_axis[edge[1]] = 1;
  double reach = 0.0;
  for (const auto& v : mesh.vertices) reach = std::max({reach, std::abs(v[0]), std::abs(v[1])});
  for (int i = 0; i < count; ++i) {
    const auto& [r, z] = mesh.vertices[i];
    if (r < 0.0) refuse_mesh("a vertex lies at negative radius");
    if (in_cell[i] && (r <= 1e-9 * reach) != (on_axis[i] == 1))
      refuse_mesh("the group \"axis\" and the vertices at radius 0 are not the same");
  }
  for (const auto& edge : mesh.contact_edges)
    for (const int vertex : edge)
      if (mesh.vertices[vertex][1] < -1e-9 * reach)
        refuse_mesh("a vertex of the group \"contact\" lies below the plate");
}

}  // namespace

void triangulate(const Mesh& mesh, dealii::Triangulation<2>& triangulation) {
  check(mesh);
  std::vector<dealii::Point<2>> vertices;
  vertices.reserve(mesh.vertices.size());
  for (const auto& v : mesh.vertices) vertices.emplace_back(v[0], v[1]);
  std::vector<dealii::CellData<2>> cells;
  cells.reserve(mesh.cells.size());
  for (const auto& c : mesh.cells) {
    dealii::CellData<2> data(4);
    for (int i = 0; i < 4; ++i) data.vertices[corners_around[i]] = static_cast<unsigned>(c[i]);
    cells.push_back(data);
  }
  dealii::SubCellData sides;
  for (const auto& edge : mesh.contact_edges) {
    dealii::CellData<1> side(2);
    for (int i = 0; i < 2; ++i) side.vertices[i] = static_cast<unsigned>(edge[i]);
    side.boundary_id = contact_boundary;
    sides.boundary_lines.push_back(side);
  }
  dealii::GridTools::consistently_order_cells(cells);
  try {
    triangulation.create_triangulation(vertices, cells, sides);
  } catch (const dealii::ExceptionBase& error) {
    refuse_mesh(std::string("deal.II cannot use it: ") + error.what());
  }
}

}  // namespace rebound::fem
