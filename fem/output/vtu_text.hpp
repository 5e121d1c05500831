#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace rebound::fem {

/// Cells as VTK numbers their kinds.
enum class VtkCell : int { bilinear = 9, biquadratic = 28 };

/// A mesh in the plane (r, z), drawn at x = r, y = z.
struct VtuMesh {
  std::vector<std::array<double, 2>> points;  ///< [m]
  std::vector<int> connectivity;              ///< cell after cell, in VTK's order
  int nodes_per_cell = 4;
  VtkCell kind = VtkCell::bilinear;
};

/// Values of all points or of all cells; vectors have three components.
struct VtuArray {
  std::string name;
  int components = 1;
  std::vector<float> values;
};

struct VtuFrame {
  double time = 0.0;  ///< [s]
  std::vector<VtuArray> of_points, of_cells;
};

/// One frame as VTK's XML UnstructuredGrid: arrays inline in base64, single
/// precision, points shared between cells.
/// Source: VTK file formats, "XML formats".
std::string vtu_text(const VtuMesh& mesh, const VtuFrame& frame);

/// The collection that ParaView opens as one animation: time [s] and file of each frame.
std::string pvd_text(const std::vector<std::pair<double, std::string>>& frames);

}  // namespace rebound::fem
