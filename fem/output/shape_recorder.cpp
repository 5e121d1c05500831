#include "fem/output/shape_recorder.hpp"

namespace rebound::fem {

ShapeRecorder::ShapeRecorder(const Discretisation& body, int frames, double expected_duration)
    : body_(body) {
  if (frames <= 0) return;
  interval_ = expected_duration / frames;
  next_ = interval_;
  for (const CellGeometry& cell : body.cells) history_.cells.push_back(cell.nodes);
  history_.time.push_back(0.0);
  history_.positions.push_back(body.position);
}

void ShapeRecorder::record_if_due(double time, const std::vector<double>& displacement) {
  if (interval_ == 0.0 || time < next_) return;
  next_ += interval_;
  std::vector<std::array<double, 2>> positions = body_.position;
  for (std::size_t node = 0; node < positions.size(); ++node) {
    positions[node][0] += displacement[2 * node];
    positions[node][1] += displacement[2 * node + 1];
  }
  history_.time.push_back(time);
  history_.positions.push_back(std::move(positions));
}

}  // namespace rebound::fem
