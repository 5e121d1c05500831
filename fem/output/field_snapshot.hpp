#pragma once

#include <vector>

#include "fem/output/cell_state.hpp"
#include "fem/output/vtu_text.hpp"

namespace rebound::fem {

/// Everything that is written or kept of one instant. Fields of nodes are
/// [node][2] (r, z) and may be longer than the mesh.
struct FieldSnapshot {
  double time = 0.0;                            ///< [s]
  const std::vector<double>& displacement;      ///< [m]
  const std::vector<double>& velocity;          ///< [m/s]
  const std::vector<double>& contact_pressure;  ///< per node, compression positive [Pa]
  const std::vector<CellState>& cells;
  Loss loss = Loss::none;
};

/// Name of what is lost, with its unit: `dissipated_energy_J_m3`, or, of branches by
/// convolution, `dissipated_or_held_energy_J_m3`.
const char* name_of_lost(Loss loss);

/// The arrays of one frame under their names, which end in their unit.
VtuFrame vtu_frame(const FieldSnapshot& now, std::size_t points);

}  // namespace rebound::fem
