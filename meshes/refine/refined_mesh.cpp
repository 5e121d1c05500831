#include "meshes/refine/refined_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace rebound {
namespace {

class Refinement {
 public:
  Refinement(const Mesh& coarse, double radius) : radius_(radius) {
    fine_.vertices = coarse.vertices;
    for (const auto& edge : coarse.contact_edges)
      if (on_sphere(edge[0]) && on_sphere(edge[1])) curved_.insert(key(edge[0], edge[1]));
    for (const auto& cell : coarse.cells) cut(cell);
    fine_.axis_edges = halves_of(coarse.axis_edges);
    fine_.contact_edges = halves_of(coarse.contact_edges);
    fine_.region_names = coarse.region_names;
    for (const int region : coarse.regions) fine_.regions.insert(fine_.regions.end(), 4, region);
  }
  Mesh mesh() && { return std::move(fine_); }

 private:
  using Edge = std::pair<int, int>;
  static Edge key(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

  bool on_sphere(int vertex) const {
    constexpr double tolerance = 1e-6;  // of the radius; files keep fewer digits
    const auto& [r, z] = fine_.vertices[vertex];
    return std::abs(std::hypot(r, z - radius_) - radius_) <= tolerance * radius_;
  }
  int add(double r, double z) {
    fine_.vertices.push_back({r, z});
    return static_cast<int>(fine_.vertices.size()) - 1;
  }
  int middle(int a, int b) {
    const auto known = middles_.find(key(a, b));
    if (known != middles_.end()) return known->second;
    double r = 0.5 * (fine_.vertices[a][0] + fine_.vertices[b][0]);
    double z = 0.5 * (fine_.vertices[a][1] + fine_.vertices[b][1]);
    if (curved_.contains(key(a, b))) {
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
  std::vector<std::array<int, 2>> halves_of(const std::vector<std::array<int, 2>>& edges) {
    std::vector<std::array<int, 2>> halves;
    for (const auto& [a, b] : edges) {
      halves.push_back({a, middle(a, b)});
      halves.push_back({middle(a, b), b});
    }
    return halves;
  }

  double radius_;
  Mesh fine_;
  std::set<Edge> curved_;
  std::map<Edge, int> middles_;
};

}  // namespace

Mesh refined_mesh(const Mesh& coarse, double radius) {
  return Refinement(coarse, radius).mesh();
}

}  // namespace rebound
