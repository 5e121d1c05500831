#include "meshes/quality/check_mesh.hpp"

#include <algorithm>
#include <cmath>

#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

class Checker {
 public:
  Checker(const Mesh& mesh, const std::string& file) : mesh_(mesh), file_(file) {}

  void run() const {
    if (mesh_.cells.empty() || mesh_.vertices.empty()) refuse("the mesh has no cells");
    for (const auto& cell : mesh_.cells) check_numbers(cell);
    for (const auto& edge : mesh_.axis_edges) check_numbers(edge);
    for (const auto& edge : mesh_.contact_edges) check_numbers(edge);
    const double size = check_coordinates();
    for (std::size_t i = 0; i < mesh_.cells.size(); ++i) check_cell(i);
    if (mesh_.axis_edges.empty()) refuse("no edges are in a group named \"axis\"");
    if (mesh_.contact_edges.empty()) refuse("no edges are in a group named \"contact\"");
    const double tolerance = 1e-9 * size;
    for (const auto& edge : mesh_.axis_edges)
      for (const int vertex : edge)
        if (std::abs(at(vertex)[0]) > tolerance)
          refuse("vertex " + std::to_string(vertex + 1) +
                 " of group \"axis\" is off the axis r = 0");
    check_touch(tolerance);
  }

 private:
  [[noreturn]] void refuse(const std::string& reason) const {
    throw Error(ExitCode::bad_input, reason, {.file = file_});
  }

  const std::array<double, 2>& at(int vertex) const {
    return mesh_.vertices[static_cast<std::size_t>(vertex)];
  }

  template <class Numbers>
  void check_numbers(const Numbers& numbers) const {
    for (const int number : numbers)
      if (number < 0 || static_cast<std::size_t>(number) >= mesh_.vertices.size())
        refuse("an edge belongs to no cell, or a cell names a vertex that does not exist");
  }

  /// Returns the largest coordinate, the length that tolerances refer to.
  double check_coordinates() const {
    double size = 0.0;
    for (const auto& [r, z] : mesh_.vertices) {
      if (!std::isfinite(r) || !std::isfinite(z)) refuse("a coordinate is not finite");
      size = std::max({size, std::abs(r), std::abs(z)});
    }
    for (std::size_t i = 0; i < mesh_.vertices.size(); ++i) {
      const auto& [r, z] = mesh_.vertices[i];
      const std::string name = "vertex " + std::to_string(i + 1);
      if (r < -1e-9 * size) refuse(name + " is left of the axis, r < 0");
      if (z < -1e-9 * size) refuse(name + " is below the plate, z < 0");
    }
    return size;
  }

  /// Every corner must turn left: counter-clockwise, convex, not degenerate.
  void check_cell(std::size_t number) const {
    const auto& cell = mesh_.cells[number];
    for (std::size_t i = 0; i < 4; ++i) {
      const auto& a = at(cell[i]);
      const auto& b = at(cell[(i + 1) % 4]);
      const auto& c = at(cell[(i + 2) % 4]);
      const double turn = (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]);
      if (!(turn > 0.0))
        refuse("cell " + std::to_string(number + 1) +
               " is inverted, clockwise or degenerate (Jacobian not positive)");
    }
  }

  void check_touch(double tolerance) const {
    const auto touches = [&](const std::array<int, 2>& edge) {
      return std::abs(at(edge[0])[1]) <= tolerance || std::abs(at(edge[1])[1]) <= tolerance;
    };
    if (std::none_of(mesh_.contact_edges.begin(), mesh_.contact_edges.end(), touches))
      refuse("no edge of group \"contact\" touches the plate z = 0");
  }

  const Mesh& mesh_;
  const std::string& file_;
};

}  // namespace

void check_mesh(const Mesh& mesh, const std::string& file) {
  Checker(mesh, file).run();
}

}  // namespace rebound
