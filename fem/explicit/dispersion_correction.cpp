#include "fem/explicit/dispersion_correction.hpp"

#include <algorithm>
#include <cmath>

namespace rebound::fem {
namespace {

/// (ω Δt/2)² of the stiffest cell, its own correction counted.
double squared_limit(double safety) {
  return 1.5 - std::sqrt(2.25 - 2.0 * safety * safety);
}

using Neighbour = NodeLaplacian::Neighbour;

/// Neighbours of every node, each row with room for all that its cells can bring.
class Rows {
 public:
  explicit Rows(const Discretisation& body)
      : begin_(body.position.size() + 1, 0), size_(body.position.size(), 0) {
    for (const CellGeometry& cell : body.cells)
      for (const int node : cell.nodes) begin_[node + 1] += nodes_per_cell - 1;
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    neighbours_.resize(static_cast<std::size_t>(begin_.back()));
  }

  /// Where the mass between `node` and `other` is added up.
  double& mass(int node, int other) {
    Neighbour* const row = neighbours_.data() + begin_[node];
    Neighbour* const end = row + size_[node];
    Neighbour* const found =
        std::find_if(row, end, [&](const Neighbour& known) { return known.node == other; });
    if (found == end) {
      ++size_[node];
      *found = {.node = other, .mass = 0.0};
    }
    return found->mass;
  }

  NodeLaplacian laplacian() {
    std::vector<int> first{0};
    first.reserve(begin_.size());
    auto end = neighbours_.begin();
    for (std::size_t node = 0; node < size_.size(); ++node) {
      const auto row = neighbours_.begin() + begin_[node];
      std::sort(row, row + size_[node],
                [](const Neighbour& a, const Neighbour& b) { return a.node < b.node; });
      end = std::copy_n(row, size_[node], end);  // at or before the row itself
      first.push_back(static_cast<int>(end - neighbours_.begin()));
    }
    return {first, neighbours_};
  }

 private:
  std::vector<int> begin_, size_;
  std::vector<Neighbour> neighbours_;
};

NodeLaplacian laplacian_of(const Discretisation& body, const std::vector<double>& frequency_squared,
                           double step_safety) {
  const double largest = *std::max_element(frequency_squared.begin(), frequency_squared.end());
  std::vector<char> may_touch(body.position.size(), 0);
  for (const int node : body.contact_nodes) may_touch[static_cast<std::size_t>(node)] = 1;
  Rows rows(body);
  for (std::size_t c = 0; c < body.cells.size(); ++c) {
    const CellGeometry& cell = body.cells[c];
    const double share = 0.5 * (1.0 - squared_limit(step_safety) * frequency_squared[c] / largest);
    for (int a = 0; a < nodes_per_cell; ++a)
      for (int b = 0; b < nodes_per_cell; ++b) {
        const int i = cell.nodes[a], j = cell.nodes[b];
        if (i >= j || may_touch[static_cast<std::size_t>(i)] ||
            may_touch[static_cast<std::size_t>(j)])
          continue;
        double &of_i = rows.mass(i, j), &of_j = rows.mass(j, i);
        for (int q = 0; q < points_per_cell; ++q) {
          const double mass =
              share * body.density * cell.weight[q] * cell.shape[q][a] * cell.shape[q][b];
          of_i += mass;
          of_j += mass;
        }
      }
  }
  return rows.laplacian();
}

}  // namespace

double DispersionCorrection::step_factor(double step_safety) {
  return std::sqrt(squared_limit(step_safety)) / step_safety;
}

DispersionCorrection::DispersionCorrection(const Discretisation& body,
                                           const std::vector<double>& frequency_squared,
                                           double step_safety)
    : laplacian_(laplacian_of(body, frequency_squared, step_safety)) {}

}  // namespace rebound::fem
