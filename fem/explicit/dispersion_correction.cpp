#include "fem/explicit/dispersion_correction.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace rebound::fem {

namespace {

/// (ω Δt/2)² of the stiffest cell, its own correction counted.
double squared_limit(double safety) {
  return 1.5 - std::sqrt(2.25 - 2.0 * safety * safety);
}

}  // namespace

double DispersionCorrection::step_factor(double step_safety) {
  return std::sqrt(squared_limit(step_safety)) / step_safety;
}

DispersionCorrection::DispersionCorrection(const Discretisation& body,
                                           const std::vector<double>& frequency_squared,
                                           double step_safety)
    : acceleration_(2 * (body.position.size() + 1), 0.0), corrected_(acceleration_) {
  const double largest = *std::max_element(frequency_squared.begin(), frequency_squared.end());
  std::vector<char> may_touch(body.position.size(), 0);
  for (const int node : body.contact_nodes) may_touch[static_cast<std::size_t>(node)] = 1;
  std::map<std::pair<int, int>, double> shared;
  for (std::size_t c = 0; c < body.cells.size(); ++c) {
    const CellGeometry& cell = body.cells[c];
    const double share = 0.5 * (1.0 - squared_limit(step_safety) * frequency_squared[c] / largest);
    for (int a = 0; a < nodes_per_cell; ++a)
      for (int b = 0; b < nodes_per_cell; ++b) {
        const int i = cell.nodes[a], j = cell.nodes[b];
        if (i >= j || may_touch[static_cast<std::size_t>(i)] ||
            may_touch[static_cast<std::size_t>(j)])
          continue;
        for (int q = 0; q < points_per_cell; ++q)
          shared[{i, j}] +=
              share * body.density * cell.weight[q] * cell.shape[q][a] * cell.shape[q][b];
      }
  }
  pairs_.reserve(shared.size());
  for (const auto& [nodes, mass] : shared) pairs_.push_back({nodes.first, nodes.second, mass});
}

const std::vector<double>& DispersionCorrection::corrected(const std::vector<double>& inverse_mass,
                                                           const std::vector<double>& force) {
  for (std::size_t i = 0; i < force.size(); ++i) {
    acceleration_[i] = force[i] * inverse_mass[i];
    corrected_[i] = force[i];
  }
  const double* y = acceleration_.data();
  double* f = corrected_.data();
  for (const Pair& pair : pairs_) {
    const int i = 2 * pair.first, j = 2 * pair.second;
    const double radial = pair.mass * (y[i] - y[j]);
    const double axial = pair.mass * (y[i + 1] - y[j + 1]);
    f[i] += radial;
    f[i + 1] += axial;
    f[j] -= radial;
    f[j + 1] -= axial;
  }
  return corrected_;
}

double DispersionCorrection::kinetic(const std::vector<double>& velocity) const {
  double sum = 0.0;
  for (const Pair& pair : pairs_) {
    const int i = 2 * pair.first, j = 2 * pair.second;
    const double radial = velocity[i] - velocity[j], axial = velocity[i + 1] - velocity[j + 1];
    sum += pair.mass * (radial * radial + axial * axial);
  }
  return 0.5 * sum;
}

}  // namespace rebound::fem
