#pragma once

#include <optional>

#include "fem/interface/fem_problem.hpp"
#include "fem/output/field_writer.hpp"
#include "fem/output/frame_clock.hpp"
#include "fem/output/shape_recorder.hpp"

namespace rebound::fem {

/// The body at rest, as files and reports draw it.
struct BodyDrawing {
  VtuMesh mesh;
  ShapeHistory shapes;  ///< cells and contact vertices alone
  int parts = 1;        ///< cells of `shapes` in one cell of the snapshots
};

/// Decides which instants are shown, and hands them to the files and to the report.
class FrameKeeper {
 public:
  /// Whether files (frames and a folder for them) or shapes are asked for.
  static bool is_requested(const FemControls& controls);

  /// Frames are spread over 1.3 of `expected_contact` [s] and go on at that rate.
  FrameKeeper(const FemControls& controls, BodyDrawing drawing, double expected_contact);

  bool is_due(double time) const { return files_.is_due(time) || pictures_.is_due(time); }
  void keep(const FieldSnapshot& now);
  const ShapeHistory& shapes() const { return shapes_.history(); }

 private:
  FrameClock files_, pictures_;
  std::optional<FieldWriter> writer_;
  ShapeRecorder shapes_;
};

/// Of the nodes of a contact group those below half of the body's height, in the same
/// order: the group may be the whole outline.
std::vector<int> lower_half(const std::vector<int>& contact_nodes,
                            const std::vector<std::array<double, 2>>& position);

/// Window of the contact pressure over the expected contact time.
inline constexpr double pressure_window = 0.02;

}  // namespace rebound::fem
