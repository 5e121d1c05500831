#include "fem/output/shape_recorder.hpp"

#include <cmath>
#include <utility>

namespace rebound::fem {

ShapeRecorder::ShapeRecorder(ShapeHistory at_rest, std::vector<std::array<double, 2>> rest,
                             int parts)
    : rest_(std::move(rest)),
      parts_(static_cast<std::size_t>(parts)),
      history_(std::move(at_rest)) {}

void ShapeRecorder::record(const FieldSnapshot& now) {
  std::vector<std::array<double, 2>> positions = rest_;
  for (std::size_t node = 0; node < positions.size(); ++node) {
    positions[node][0] += now.displacement[2 * node];
    positions[node][1] += now.displacement[2 * node + 1];
  }
  history_.time.push_back(now.time);
  history_.positions.push_back(std::move(positions));
  std::vector<float> pressure;
  for (const int vertex : history_.contact_vertices)
    pressure.push_back(static_cast<float>(now.contact_pressure[vertex]));
  history_.contact_pressure.push_back(std::move(pressure));
  record_fields(now);
}

void ShapeRecorder::record_fields(const FieldSnapshot& now) {
  std::size_t index = 0;
  const auto add = [&](ShapeQuantity quantity, const auto& of_cell) {
    if (history_.fields.size() == index) history_.fields.push_back({quantity, {}});
    std::vector<float> values;
    values.reserve(history_.cells.size());
    for (std::size_t cell = 0; cell < history_.cells.size(); ++cell)
      values.push_back(static_cast<float>(of_cell(cell)));
    history_.fields[index++].values.push_back(std::move(values));
  };
  const auto state = [&](std::size_t cell) -> const CellState& { return now.cells[cell / parts_]; };
  add(ShapeQuantity::von_mises, [&](std::size_t c) { return state(c).von_mises; });
  add(ShapeQuantity::pressure, [&](std::size_t c) { return state(c).pressure; });
  add(ShapeQuantity::stored, [&](std::size_t c) { return state(c).stored; });
  if (now.loss != Loss::none)
    add(now.loss == Loss::dissipated ? ShapeQuantity::dissipated
                                     : ShapeQuantity::dissipated_or_held,
        [&](std::size_t c) { return state(c).lost; });
  add(ShapeQuantity::speed, [&](std::size_t cell) {
    double r = 0.0, z = 0.0;
    for (const int node : history_.cells[cell]) {
      r += 0.25 * now.velocity[2 * node];
      z += 0.25 * now.velocity[2 * node + 1];
    }
    return std::hypot(r, z);
  });
}

}  // namespace rebound::fem
