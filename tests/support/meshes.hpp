#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "lumped/problem/mesh.hpp"

namespace rebound::test {

/// Radius, length and cell counts of a cylinder standing on the plate.
struct CylinderMesh {
  double radius;
  double length;
  int cells_across;
  int cells_along;
};

/// Structured mesh of a cylinder: axis at r = 0, its lower end in group "contact".
inline Mesh cylinder(const CylinderMesh& shape) {
  Mesh mesh;
  const auto vertex = [&](int i, int j) { return j * (shape.cells_across + 1) + i; };
  for (int j = 0; j <= shape.cells_along; ++j)
    for (int i = 0; i <= shape.cells_across; ++i)
      mesh.vertices.push_back(
          {shape.radius * i / shape.cells_across, shape.length * j / shape.cells_along});
  for (int j = 0; j < shape.cells_along; ++j) {
    mesh.axis_edges.push_back({vertex(0, j), vertex(0, j + 1)});
    for (int i = 0; i < shape.cells_across; ++i)
      mesh.cells.push_back(
          {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
  }
  for (int i = 0; i < shape.cells_across; ++i)
    mesh.contact_edges.push_back({vertex(i, 0), vertex(i + 1, 0)});
  return mesh;
}

/// Cuts every cell of a sphere's mesh into four; new vertices of the contact
/// group are put on the sphere, so that the bodies converge to it.
class SphereRefinement {
 public:
  SphereRefinement(const Mesh& coarse, double radius) : radius_(radius) {
    fine_.vertices = coarse.vertices;
    for (const auto& edge : coarse.contact_edges) on_sphere_.insert(key(edge[0], edge[1]));
    for (const auto& cell : coarse.cells) cut(cell);
    fine_.axis_edges = cut_edges(coarse.axis_edges);
    fine_.contact_edges = cut_edges(coarse.contact_edges);
  }
  Mesh mesh() && { return std::move(fine_); }

 private:
  using Edge = std::pair<int, int>;
  static Edge key(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

  int add(double r, double z) {
    fine_.vertices.push_back({r, z});
    return static_cast<int>(fine_.vertices.size()) - 1;
  }
  int middle(int a, int b) {
    const auto known = middles_.find(key(a, b));
    if (known != middles_.end()) return known->second;
    double r = 0.5 * (fine_.vertices[a][0] + fine_.vertices[b][0]);
    double z = 0.5 * (fine_.vertices[a][1] + fine_.vertices[b][1]);
    if (on_sphere_.contains(key(a, b))) {
      const double scale = radius_ / std::hypot(r, z - radius_);
      r *= scale;
      z = radius_ + scale * (z - radius_);
    }
    return middles_[key(a, b)] = add(r, z);
  }
  void cut(const std::array<int, 4>& cell) {
    double r = 0.0, z = 0.0;
    std::array<int, 4> between{};
    for (int i = 0; i < 4; ++i) {
      between[i] = middle(cell[i], cell[(i + 1) % 4]);
      r += 0.25 * fine_.vertices[cell[i]][0];
      z += 0.25 * fine_.vertices[cell[i]][1];
    }
    const int centre = add(r, z);
    for (int i = 0; i < 4; ++i)
      fine_.cells.push_back({cell[i], between[i], centre, between[(i + 3) % 4]});
  }
  std::vector<std::array<int, 2>> cut_edges(const std::vector<std::array<int, 2>>& edges) {
    std::vector<std::array<int, 2>> halves;
    for (const auto& [a, b] : edges) {
      halves.push_back({a, middle(a, b)});
      halves.push_back({middle(a, b), b});
    }
    return halves;
  }

  double radius_;
  Mesh fine_;
  std::set<Edge> on_sphere_;
  std::map<Edge, int> middles_;
};

inline Mesh refined_sphere(const Mesh& coarse, double radius) {
  return SphereRefinement(coarse, radius).mesh();
}

}  // namespace rebound::test
