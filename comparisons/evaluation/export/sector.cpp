#include "comparisons/evaluation/export/sector.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

namespace rebound {
namespace {

using Place = std::array<double, 2>;
using Side = std::pair<int, int>;

Side side_between(int a, int b) {
  return {std::min(a, b), std::max(a, b)};
}

Place middle_of(const Place& a, const Place& b) {
  return {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])};
}

/// Volume of one cell turned about the axis, 3×3 Gauss points.
double volume_of(const QuadraticSection& section, const std::array<int, 8>& cell) {
  constexpr double place[3] = {-0.7745966692414834, 0.0, 0.7745966692414834};
  constexpr double weight[3] = {5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};
  constexpr double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  constexpr double between[4][2] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
  double volume = 0.0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const double x = place[i], y = place[j];
      double r = 0.0, slope[2][2] = {};
      const auto add = [&](int node, double value, double by_x, double by_y) {
        const Place& p = section.nodes[cell[node]];
        r += value * p[0];
        for (int k = 0; k < 2; ++k) {
          slope[k][0] += by_x * p[k];
          slope[k][1] += by_y * p[k];
        }
      };
      for (int k = 0; k < 4; ++k) {
        const double a = corner[k][0], b = corner[k][1], u = 1 + a * x, v = 1 + b * y;
        add(k, 0.25 * u * v * (a * x + b * y - 1), 0.25 * a * v * (2 * a * x + b * y),
            0.25 * b * u * (a * x + 2 * b * y));
      }
      for (int k = 0; k < 4; ++k) {
        const double a = between[k][0], b = between[k][1];
        if (a == 0.0)
          add(4 + k, 0.5 * (1 - x * x) * (1 + b * y), -x * (1 + b * y), 0.5 * b * (1 - x * x));
        else
          add(4 + k, 0.5 * (1 - y * y) * (1 + a * x), 0.5 * a * (1 - y * y), -y * (1 + a * x));
      }
      volume += weight[i] * weight[j] * 2.0 * std::numbers::pi * r *
                (slope[0][0] * slope[1][1] - slope[0][1] * slope[1][0]);
    }
  return volume;
}

}  // namespace

QuadraticSection quadratic_section(const Mesh& mesh, double radius) {
  constexpr double tolerance = 1e-6;  // of the radius; files keep fewer digits
  QuadraticSection section{.nodes = mesh.vertices};
  std::set<Side> contact;
  for (const auto& edge : mesh.contact_edges) contact.insert(side_between(edge[0], edge[1]));
  const auto on_sphere = [&](int vertex) {
    const Place& p = mesh.vertices[vertex];
    return std::abs(std::hypot(p[0], p[1] - radius) - radius) <= tolerance * radius;
  };
  std::map<Side, int> middles;
  for (const auto& corners : mesh.cells) {
    std::array<int, 8> cell{};
    for (int i = 0; i < 4; ++i) {
      const int from = corners[i], to = corners[(i + 1) % 4];
      const Side side = side_between(from, to);
      const bool touches = contact.contains(side);
      const auto [found, is_new] =
          middles.try_emplace(side, static_cast<int>(section.nodes.size()));
      if (is_new) {
        Place place = middle_of(mesh.vertices[from], mesh.vertices[to]);
        if (touches && on_sphere(from) && on_sphere(to)) {
          const double out = radius / std::hypot(place[0], place[1] - radius);
          place = {out * place[0], radius + out * (place[1] - radius)};
        }
        section.nodes.push_back(place);
      }
      if (touches) section.contact_sides.push_back({static_cast<int>(section.cells.size()), i});
      cell[i] = from;
      cell[4 + i] = found->second;
    }
    section.cells.push_back(cell);
    section.volume += volume_of(section, cell);
  }
  return section;
}

namespace {

/// Copies of each node of the section around the axis, two a slice; odd ones of corners alone.
class SectorBuilder {
 public:
  SectorBuilder(const QuadraticSection& section, const SectorRequest& request)
      : section_(section), request_(request), is_corner_(section.nodes.size(), false) {
    for (const auto& cell : section.cells)
      for (int i = 0; i < 4; ++i) is_corner_[cell[i]] = true;
  }

  Sector build() {
    add_nodes();
    for (int slice = 0; slice < request_.slices; ++slice) add_slice(slice);
    return std::move(sector_);
  }

 private:
  void add_nodes();
  void add_slice(int slice);

  const QuadraticSection& section_;
  const SectorRequest& request_;
  std::vector<bool> is_corner_;
  std::vector<std::vector<int>> copies_;
  Sector sector_;
};

void SectorBuilder::add_nodes() {
  double reach = 0.0;
  for (const Place& p : section_.nodes) reach = std::max(reach, p[0]);
  const int turns = 2 * request_.slices;
  for (std::size_t i = 0; i < section_.nodes.size(); ++i) {
    const double r = section_.nodes[i][0], z = section_.nodes[i][1];
    const int next = static_cast<int>(sector_.nodes.size());
    if (r <= 1e-9 * reach) {
      sector_.nodes.push_back({0.0, 0.0, z});
      sector_.axis.push_back(next);
      copies_.emplace_back(turns + 1, next);
      continue;
    }
    copies_.emplace_back(turns + 1, -1);
    for (int turn = 0; turn <= turns; ++turn) {
      if (turn % 2 == 1 && !is_corner_[i]) continue;
      const double angle = request_.from + (request_.to - request_.from) * turn / turns;
      copies_.back()[turn] = static_cast<int>(sector_.nodes.size());
      sector_.nodes.push_back({r * std::cos(angle), r * std::sin(angle), z});
    }
    sector_.first_plane.push_back(copies_.back().front());
    sector_.last_plane.push_back(copies_.back().back());
  }
}

void SectorBuilder::add_slice(int slice) {
  // Counter-clockwise in (r, z) looks against the turning: the brick begins at the larger angle.
  const int begin = 2 * slice + 2, middle = begin - 1, end = begin - 2;
  const int before = static_cast<int>(sector_.bricks.size());
  for (const auto& cell : section_.cells) {
    std::array<int, 20> brick{};
    for (int i = 0; i < 4; ++i) {
      brick[i] = copies_[cell[i]][begin];
      brick[4 + i] = copies_[cell[i]][end];
      brick[8 + i] = copies_[cell[4 + i]][begin];
      brick[12 + i] = copies_[cell[4 + i]][end];
      brick[16 + i] = copies_[cell[i]][middle];
    }
    sector_.bricks.push_back(brick);
  }
  for (const auto& side : section_.contact_sides)
    sector_.contact_faces.push_back({before + side[0], side[1]});
}

}  // namespace

Sector sector_of(const QuadraticSection& section, const SectorRequest& request) {
  return SectorBuilder(section, request).build();
}

}  // namespace rebound
