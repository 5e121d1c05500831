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
      const auto [found, is_new] = middles.try_emplace(side, static_cast<int>(section.nodes.size()));
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

Sector sector_of(const QuadraticSection& section, double angle) {
  double reach = 0.0;
  for (const Place& p : section.nodes) reach = std::max(reach, p[0]);
  Sector sector{.angle = angle};
  std::vector<std::array<int, 3>> copies;  // at −, 0, + half the angle
  std::vector<bool> has_middle(section.nodes.size(), false);
  for (const auto& cell : section.cells)
    for (int i = 0; i < 4; ++i) has_middle[cell[i]] = true;
  for (std::size_t i = 0; i < section.nodes.size(); ++i) {
    const double r = section.nodes[i][0], z = section.nodes[i][1];
    const auto add = [&](double turned) {
      sector.nodes.push_back({r * std::cos(turned), r * std::sin(turned), z});
      return static_cast<int>(sector.nodes.size()) - 1;
    };
    if (r <= 1e-9 * reach) {
      const int node = static_cast<int>(sector.nodes.size());
      sector.nodes.push_back({0.0, 0.0, z});
      sector.axis.push_back(node);
      copies.push_back({node, node, node});
      continue;
    }
    const int first = add(-0.5 * angle);
    const int second = has_middle[i] ? add(0.0) : -1;
    const int third = add(0.5 * angle);
    sector.sides[0].push_back(first);
    sector.sides[1].push_back(third);
    copies.push_back({first, second, third});
  }
  for (const auto& cell : section.cells) {
    std::array<int, 20> brick{};  // counter-clockwise in (r, z) looks along −y: begin at +
    for (int i = 0; i < 4; ++i) {
      brick[i] = copies[cell[i]][2];
      brick[4 + i] = copies[cell[i]][0];
      brick[8 + i] = copies[cell[4 + i]][2];
      brick[12 + i] = copies[cell[4 + i]][0];
      brick[16 + i] = copies[cell[i]][1];
    }
    sector.bricks.push_back(brick);
  }
  sector.contact_faces = section.contact_sides;
  return sector;
}

}  // namespace rebound
