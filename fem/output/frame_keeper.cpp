#include "fem/output/frame_keeper.hpp"

#include <algorithm>
#include <utility>

namespace rebound::fem {
namespace {

constexpr double covered = 1.3;  ///< contact times that the frames are spread over

int file_frames(const FemControls& controls) {
  return controls.field_directory.empty() ? 0 : controls.field_frames;
}

}  // namespace

bool FrameKeeper::is_requested(const FemControls& controls) {
  return file_frames(controls) > 0 || controls.shape_frames > 0;
}

FrameKeeper::FrameKeeper(const FemControls& controls, BodyDrawing drawing, double expected_contact)
    : files_(file_frames(controls), covered * expected_contact),
      pictures_(controls.shape_frames, covered * expected_contact),
      shapes_(std::move(drawing.shapes), drawing.mesh.points, drawing.parts) {
  if (file_frames(controls) > 0) writer_.emplace(std::move(drawing.mesh), controls.field_directory);
}

void FrameKeeper::keep(const FieldSnapshot& now) {
  if (files_.is_due(now.time)) {
    writer_->write(now);
    files_.tick();
  }
  if (pictures_.is_due(now.time)) {
    shapes_.record(now);
    pictures_.tick();
  }
}

std::vector<int> lower_half(const std::vector<int>& contact_nodes,
                            const std::vector<std::array<double, 2>>& position) {
  double top = 0.0;
  for (const auto& [r, z] : position) top = std::max(top, z);
  std::vector<int> lower;
  for (const int node : contact_nodes)
    if (position[node][1] < 0.5 * top) lower.push_back(node);
  return lower;
}

}  // namespace rebound::fem
