#include "fem/output/field_snapshot.hpp"

#include <string>
#include <utility>

namespace rebound::fem {
namespace {

/// (r, z) per node as the three components that "Warp By Vector" takes.
VtuArray vectors(std::string name, const std::vector<double>& field, std::size_t points) {
  VtuArray array{std::move(name), 3, {}};
  array.values.reserve(3 * points);
  for (std::size_t node = 0; node < points; ++node)
    array.values.insert(array.values.end(), {static_cast<float>(field[2 * node]),
                                             static_cast<float>(field[2 * node + 1]), 0.0f});
  return array;
}

template <class Quantity>
VtuArray of_cells(std::string name, const std::vector<CellState>& cells, const Quantity& quantity) {
  VtuArray array{std::move(name), 1, {}};
  array.values.reserve(cells.size());
  for (const CellState& cell : cells) array.values.push_back(static_cast<float>(quantity(cell)));
  return array;
}

}  // namespace

const char* name_of_lost(Loss loss) {
  return loss == Loss::dissipated_or_held ? "dissipated_or_held_energy_J_m3"
                                          : "dissipated_energy_J_m3";
}

VtuFrame vtu_frame(const FieldSnapshot& now, std::size_t points) {
  VtuFrame frame{.time = now.time, .of_points = {}, .of_cells = {}};
  frame.of_points = {vectors("displacement_m", now.displacement, points),
                     vectors("velocity_m_s", now.velocity, points),
                     {"contact_pressure_Pa", 1, {}}};
  auto& pressure = frame.of_points.back().values;
  for (std::size_t node = 0; node < points; ++node)
    pressure.push_back(static_cast<float>(now.contact_pressure[node]));

  const auto add = [&](const char* name, const auto& quantity) {
    frame.of_cells.push_back(of_cells(name, now.cells, quantity));
  };
  add("cauchy_stress_rr_Pa", [](const CellState& c) { return c.cauchy.rr; });
  add("cauchy_stress_zz_Pa", [](const CellState& c) { return c.cauchy.zz; });
  add("cauchy_stress_tt_Pa", [](const CellState& c) { return c.cauchy.tt; });
  add("cauchy_stress_rz_Pa", [](const CellState& c) { return c.cauchy.rz; });
  add("von_mises_stress_Pa", [](const CellState& c) { return c.von_mises; });
  add("pressure_Pa", [](const CellState& c) { return c.pressure; });
  add("stored_energy_J_m3", [](const CellState& c) { return c.stored; });
  add("energy_held_in_branches_J_m3", [](const CellState& c) { return c.held; });
  add(name_of_lost(now.loss), [](const CellState& c) { return c.lost; });
  add("volume_at_rest_m3", [](const CellState& c) { return c.volume; });
  return frame;
}

}  // namespace rebound::fem
