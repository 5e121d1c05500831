#include "fem/discretisation/node_order.hpp"

#include <deal.II/dofs/dof_renumbering.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "fem/discretisation/discretisation.hpp"

namespace rebound::fem {
namespace {

using Number = dealii::types::global_dof_index;
using Numbers = std::vector<Number>;  ///< new by old

/// Of each used vertex, in the order of the mesh.
Numbers numbers_of_mesh(const dealii::DoFHandler<2>& nodes) {
  Numbers node_of_vertex(nodes.get_triangulation().n_vertices(), nodes.n_dofs());
  for (const auto& cell : nodes.active_cell_iterators())
    for (unsigned corner = 0; corner < 4; ++corner)
      node_of_vertex[cell->vertex_index(corner)] = cell->vertex_dof_index(corner, 0);
  Numbers numbers(nodes.n_dofs());
  Number next = 0;
  for (const Number node : node_of_vertex)
    if (node < nodes.n_dofs()) numbers[node] = next++;
  return numbers;
}

std::size_t diagonals(const dealii::DoFHandler<2>& nodes, const Numbers& numbers) {
  std::vector<std::vector<long>> distances(nodes.n_dofs() / nodes_per_block + 1);
  for (const auto& cell : nodes.active_cell_iterators())
    for (unsigned a = 0; a < 4; ++a)
      for (unsigned b = 0; b < 4; ++b) {
        const Number from = numbers[cell->vertex_dof_index(a, 0)];
        const auto distance =
            static_cast<long>(numbers[cell->vertex_dof_index(b, 0)]) - static_cast<long>(from);
        auto& known = distances[from / nodes_per_block];
        if (distance != 0 && std::find(known.begin(), known.end(), distance) == known.end())
          known.push_back(distance);
      }
  std::size_t count = 0;
  for (const auto& known : distances) count += known.size();
  return count;
}

}  // namespace

void number_nodes(dealii::DoFHandler<2>& nodes) {
  const Numbers of_mesh = numbers_of_mesh(nodes);
  Numbers by_neighbours(nodes.n_dofs());
  dealii::DoFRenumbering::compute_Cuthill_McKee(by_neighbours, nodes, true);
  const bool keep = diagonals(nodes, of_mesh) <= diagonals(nodes, by_neighbours);
  nodes.renumber_dofs(keep ? of_mesh : by_neighbours);
}

}  // namespace rebound::fem
