#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "fem/output/field_snapshot.hpp"

namespace rebound::fem {

/// Writes VTU frames of the moving body and the PVD that lists them, for ParaView.
///
/// Points are those at rest; "Warp By Vector" with `displacement_m` shows the shape.
/// Files: frame-0000.vtu … and impact.pvd in `folder`. Each is there whole or not
/// at all, and the list is renewed with every frame: an interrupted run leaves a
/// list of what there is. Frames and list of an earlier run are removed first.
/// Errors: Error(input_output_failed) when a file cannot be written.
class FieldWriter {
 public:
  FieldWriter(VtuMesh mesh, const std::string& folder);

  void write(const FieldSnapshot& now);

 private:
  VtuMesh mesh_;
  std::filesystem::path folder_;
  std::vector<std::pair<double, std::string>> frames_;
};

}  // namespace rebound::fem
