#include "meshes/quality/mesh_quality.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace rebound {
namespace {

using Point = std::array<double, 2>;

Point difference(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1]};
}
double cross(const Point& a, const Point& b) {
  return a[0] * b[1] - a[1] * b[0];
}
double length(const Point& a) {
  return std::hypot(a[0], a[1]);
}

double triangle_of_revolution(const Point& a, const Point& b, const Point& c) {
  const double area = 0.5 * cross(difference(b, a), difference(c, a));
  return 2.0 * std::numbers::pi * area * (a[0] + b[0] + c[0]) / 3.0;
}

}  // namespace

MeshQuality measure_quality(const Mesh& mesh) {
  MeshQuality quality;
  quality.cells = static_cast<int>(mesh.cells.size());
  quality.vertices = static_cast<int>(mesh.vertices.size());
  quality.smallest_edge = std::numeric_limits<double>::infinity();
  quality.worst_scaled_jacobian = std::numeric_limits<double>::infinity();
  for (const auto& cell : mesh.cells) {
    std::array<Point, 4> corner;
    for (int i = 0; i < 4; ++i) corner[i] = mesh.vertices[cell[i]];
    for (int i = 0; i < 4; ++i) {
      const Point ahead = difference(corner[(i + 1) % 4], corner[i]);
      const Point behind = difference(corner[(i + 3) % 4], corner[i]);
      quality.smallest_edge = std::min(quality.smallest_edge, length(ahead));
      quality.largest_edge = std::max(quality.largest_edge, length(ahead));
      quality.worst_scaled_jacobian = std::min(
          quality.worst_scaled_jacobian, cross(ahead, behind) / (length(ahead) * length(behind)));
    }
    quality.volume += triangle_of_revolution(corner[0], corner[1], corner[2]) +
                      triangle_of_revolution(corner[0], corner[2], corner[3]);
  }
  // Edges near the plate: the lowest 5 % of the contact group's height.
  double highest = 0.0;
  for (const auto& edge : mesh.contact_edges)
    highest = std::max(highest, mesh.vertices[edge[0]][1]);
  double sum = 0.0;
  int count = 0;
  for (const auto& edge : mesh.contact_edges) {
    const Point& a = mesh.vertices[edge[0]];
    const Point& b = mesh.vertices[edge[1]];
    if (std::max(a[1], b[1]) > 0.05 * highest) continue;
    sum += length(difference(b, a));
    ++count;
  }
  quality.contact_edge_length = count > 0 ? sum / count : 0.0;
  return quality;
}

}  // namespace rebound
