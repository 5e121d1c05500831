#include "fem/kernel/cell_batches.hpp"

#include "fem/discretisation/layer_factors.hpp"

#include <algorithm>
#include <numeric>

namespace rebound::fem {
namespace {

constexpr int padding = -1;

/// Order of cells such that each run of `width` shares no node where possible.
/// Cells are taken in order of their lowest node, for locality; a cell that
/// collides with its batch waits for the next.
std::vector<int> deal_cells(const Discretisation& body, int width) {
  const auto cell_count = static_cast<int>(body.cells.size());
  std::vector<int> waiting(cell_count);
  std::iota(waiting.begin(), waiting.end(), 0);
  const auto lowest = [&](int c) {
    return *std::min_element(body.cells[c].nodes.begin(), body.cells[c].nodes.end());
  };
  std::stable_sort(waiting.begin(), waiting.end(),
                   [&](int a, int b) { return lowest(a) < lowest(b); });

  std::vector<int> order;
  std::vector<int> last_batch_of_node(body.position.size(), -1);
  constexpr std::size_t look_ahead = 200;
  std::size_t first = 0;
  for (int batch = 0; first < waiting.size(); ++batch) {
    int filled = 0;
    const std::size_t end = std::min(waiting.size(), first + look_ahead);
    for (std::size_t i = first; i < end && filled < width; ++i) {
      if (waiting[i] == padding) continue;
      const auto& nodes = body.cells[waiting[i]].nodes;
      if (std::any_of(nodes.begin(), nodes.end(),
                      [&](int n) { return last_batch_of_node[n] == batch; }))
        continue;
      for (const int n : nodes) last_batch_of_node[n] = batch;
      order.push_back(waiting[i]);
      waiting[i] = padding;
      ++filled;
    }
    order.insert(order.end(), width - filled, padding);
    while (first < waiting.size() && waiting[first] == padding) ++first;
  }
  return order;
}

}  // namespace

CellBatches::CellBatches(const Discretisation& body, const ViscoelasticConstants& material,
                         int width)
    : width_(width),
      point_factors_(layer_factors(body, material.layers)),
      cell_frequency_squared_(cell_frequencies(
          body, material.instantaneous,
          {.factors = point_factors_, .mean_dilatation = material.mean_dilatation})),
      cell_of_slot_(deal_cells(body, width)) {
  const std::vector<int>& order = cell_of_slot_;
  const int unused_node = body.node_count();
  nodes_.assign(order.size() * nodes_per_cell, unused_node);
  // Padding lanes: zero gradients and weight leave F = 1 and no force.
  geometry_.assign(order.size() * points_per_cell * geometry_stride, 0.0);
  rest_frequency_squared_.assign(order.size(), 0.0);
  // Padding lanes are cells at rest: shares that sum to 1 leave their volume ratio 1.
  if (material.mean_dilatation)
    volume_shares_.assign(order.size() * points_per_cell, 1.0 / points_per_cell);

  for (std::size_t slot = 0; slot < order.size(); ++slot) {
    if (order[slot] == padding) continue;
    const CellGeometry& cell = body.cells[order[slot]];
    const std::size_t batch = slot / width;
    const std::size_t lane = slot % width;
    rest_frequency_squared_[slot] = cell_frequency_squared_[order[slot]];
    for (int i = 0; i < nodes_per_cell; ++i)
      nodes_[(batch * nodes_per_cell + i) * width + lane] = cell.nodes[i];
    const double cell_volume = std::accumulate(cell.weight.begin(), cell.weight.end(), 0.0);
    for (int q = 0; q < points_per_cell; ++q) {
      if (material.mean_dilatation)
        volume_shares_[(batch * points_per_cell + q) * width + lane] = cell.weight[q] / cell_volume;
      double* at =
          geometry_.data() + (batch * points_per_cell + q) * geometry_stride * width + lane;
      for (int i = 0; i < nodes_per_cell; ++i) {
        at[i * width] = cell.gradient[q][i][0];
        at[(nodes_per_cell + i) * width] = cell.gradient[q][i][1];
      }
      at[8 * width] = 1.0 / cell.radius[q];
      // Stress and energy of a point are in proportion to its weight: so are its moduli.
      at[9 * width] = cell.weight[q] * layer_factor(order[slot], q);
    }
  }

  arrays_.batches = static_cast<int>(order.size()) / width;
  arrays_.cells = static_cast<int>(body.cells.size());
  arrays_.nodes = nodes_.data();
  arrays_.geometry = geometry_.data();
  arrays_.rest_frequency_squared = rest_frequency_squared_.data();
  arrays_.volume_shares = volume_shares_.empty() ? nullptr : volume_shares_.data();
  arrays_.elastic = material.elastic;
  arrays_.long_term_deviatoric = material.long_term_deviatoric;
  arrays_.long_term_volumetric = material.long_term_volumetric;
  arrays_.branches = static_cast<int>(material.branches.size());
  arrays_.inelastic = material.inelastic;
  arrays_.history_per_point =
      arrays_.branches * history_stride + (material.inelastic.remembers_strain ? 1 : 0);
}

std::vector<double> CellBatches::make_history() const {
  return std::vector<double>(static_cast<std::size_t>(arrays_.batches) * points_per_cell *
                                 arrays_.history_per_point * width_,
                             0.0);
}

}  // namespace rebound::fem
