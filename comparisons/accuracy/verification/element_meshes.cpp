#include "comparisons/accuracy/verification/element_meshes.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "meshes/generate/cylinder_mesh.hpp"

namespace rebound {

Mesh bent_cylinder(int n) {
  Mesh mesh = cylinder_mesh({.radius = 1.0, .length = 1.0, .cells_across = n, .cells_along = n});
  for (auto& [r, z] : mesh.vertices) {
    const double bend = 0.06 * std::sin(std::numbers::pi * r) * std::sin(std::numbers::pi * z);
    r += bend;
    z -= bend;
  }
  return mesh;
}

Mesh distorted_cylinder() {
  constexpr int across = 4, along = 5;
  Mesh mesh =
      cylinder_mesh({.radius = 1.0, .length = 1.2, .cells_across = across, .cells_along = along});
  for (int j = 1; j < along; ++j)
    for (int i = 1; i < across; ++i) {
      const int vertex = j * (across + 1) + i;
      mesh.vertices[vertex][0] += 0.05 * std::sin(5.0 * vertex);
      mesh.vertices[vertex][1] += 0.05 * std::cos(7.0 * vertex);
    }
  return mesh;
}

Mesh quarter_of_thick_sphere(double inner, double outer, int cells_around) {
  Mesh mesh = cylinder_mesh({.radius = outer - inner,
                             .length = 1.0,
                             .cells_across = cells_around / 2,
                             .cells_along = cells_around});
  mesh.axis_edges.clear();
  mesh.contact_edges.clear();
  const int across = cells_around / 2, row = across + 1;
  for (auto& [r, z] : mesh.vertices) {
    // Even in the logarithm of the distance; the side r = 0 of the cylinder becomes the inner one.
    const double rho = inner * std::pow(outer / inner, r / (outer - inner));
    const double angle = 0.5 * std::numbers::pi * z;
    r = angle < 0.5 * std::numbers::pi * (1.0 - 1e-12) ? rho * std::cos(angle) : 0.0;
    z = rho * std::sin(angle);
  }
  for (int i = 0; i < across; ++i)
    mesh.axis_edges.push_back({cells_around * row + i, cells_around * row + i + 1});
  for (int j = 0; j < cells_around; ++j) mesh.contact_edges.push_back({j * row, (j + 1) * row});
  return mesh;
}

Mesh layer_mesh(const LayerMesh& layer) {
  constexpr double fine_width = 0.8, growth = 1.15;
  const auto grown = [&](double from, double to) {
    std::vector<double> places;
    double step = layer.finest;
    for (double at = from; at < to; at += step, step *= growth) places.push_back(at);
    places.push_back(to + step);
    const double scale = (to - from) / (places.back() - from);
    for (double& at : places) at = from + scale * (at - from);
    places.back() = to;
    return places;
  };
  const int even = static_cast<int>(std::lround(fine_width / layer.finest));
  std::vector<double> across(static_cast<std::size_t>(even));
  for (int i = 0; i < even; ++i) across[static_cast<std::size_t>(i)] = fine_width * i / even;
  const std::vector<double> outer = grown(fine_width, layer.width);
  across.insert(across.end(), outer.begin(), outer.end());
  std::vector<double> down = grown(0.0, layer.height);
  Mesh mesh = cylinder_mesh({.radius = 1.0,
                             .length = 1.0,
                             .cells_across = static_cast<int>(across.size()) - 1,
                             .cells_along = static_cast<int>(down.size()) - 1});
  const std::size_t row = across.size();
  for (std::size_t k = 0; k < mesh.vertices.size(); ++k)
    mesh.vertices[k] = {across[k % row], layer.height - down[down.size() - 1 - k / row]};
  return mesh;
}

}  // namespace rebound
