#include "tests/verification/calculix/quarter_disc.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace rebound::calculix {
namespace {

using Point = std::array<double, 2>;

/// n intervals of [0, 1], the first `growth` times smaller than the last.
std::vector<double> graded(int n, double growth) {
  std::vector<double> places = {0.0};
  const double factor = std::pow(growth, 1.0 / (n - 1));
  for (int i = 0; i < n; ++i) places.push_back(places.back() + std::pow(factor, i));
  for (double& place : places) place /= places.back();
  return places;
}

/// On the unit circle about the centre, from the lower pole (0) to the equator (1).
Point arc(double share) {
  const double angle = 0.5 * std::numbers::pi * share;
  return {std::sin(angle), -std::cos(angle)};
}

Point between(const Point& a, const Point& b, double share) {
  return {(1.0 - share) * a[0] + share * b[0], (1.0 - share) * a[1] + share * b[1]};
}

void add_block(QuadraticMesh& mesh, const std::vector<double>& us, const std::vector<double>& vs,
               const std::function<Point(double, double)>& place) {
  for (std::size_t i = 0; i + 1 < us.size(); ++i)
    for (std::size_t j = 0; j + 1 < vs.size(); ++j) {
      const double u = 0.5 * (us[i] + us[i + 1]), v = 0.5 * (vs[j] + vs[j + 1]);
      std::array<Point, 8> p = {
          place(us[i], vs[j]),     place(us[i + 1], vs[j]), place(us[i + 1], vs[j + 1]),
          place(us[i], vs[j + 1]), place(u, vs[j]),         place(us[i + 1], v),
          place(u, vs[j + 1]),     place(us[i], v)};
      double area = 0.0;
      for (int k = 0; k < 4; ++k) area += p[k][0] * p[(k + 1) % 4][1] - p[(k + 1) % 4][0] * p[k][1];
      if (area < 0.0) p = {p[0], p[3], p[2], p[1], p[7], p[6], p[5], p[4]};
      std::array<int, 8> element{};
      for (int k = 0; k < 8; ++k) element[k] = mesh.node_at(p[k]);
      mesh.elements.push_back(element);
    }
}

}  // namespace

int QuadraticMesh::node_at(const Point& place) {
  const std::array<long, 2> key = {std::lround(place[0] * 1e8), std::lround(place[1] * 1e8)};
  const auto found = std::lower_bound(places_.begin(), places_.end(), std::pair{key, -1});
  if (found != places_.end() && found->first == key) return found->second;
  const int node = static_cast<int>(nodes.size());
  places_.insert(found, {key, node});
  nodes.push_back(place);
  return node;
}

QuadraticMesh lower_half(double radius, int fineness) {
  const Point centre = {0.0, 0.0}, side = {0.45, 0.0}, corner = {0.38, -0.38}, below = {0.0, -0.5};
  const auto along = graded(2 * fineness, 4.0), inward = graded(2 * fineness, 5.0);
  std::vector<double> even;
  for (int i = 0; i <= fineness; ++i) even.push_back(static_cast<double>(i) / fineness);
  const auto scaled = [&](const Point& p) { return Point{radius * p[0], radius * (1.0 + p[1])}; };
  QuadraticMesh mesh;
  add_block(mesh, along, even, [&](double u, double v) {
    return scaled(between(between(centre, side, u), between(below, corner, u), v));
  });
  add_block(mesh, along, inward, [&](double u, double w) {
    return scaled(between(arc(0.5 * u), between(below, corner, u), w));
  });
  add_block(mesh, even, inward, [&](double v, double w) {
    return scaled(between(arc(1.0 - 0.5 * v), between(side, corner, v), w));
  });
  return mesh;
}

QuadraticMesh whole_sphere(double radius, int fineness) {
  QuadraticMesh mesh = lower_half(radius, fineness);
  const auto half = mesh.elements;
  for (const auto& e : half) {
    std::array<int, 8> image{};
    for (int k = 0; k < 8; ++k) {
      const Point p = mesh.nodes[e[k]];
      image[k] = mesh.node_at({p[0], 2.0 * radius - p[1]});
    }
    mesh.elements.push_back(
        {image[0], image[3], image[2], image[1], image[7], image[6], image[5], image[4]});
  }
  return mesh;
}

QuadraticMesh plate(double width, double height, int cells) {
  QuadraticMesh mesh;
  std::vector<double> across;
  for (int i = 0; i <= cells; ++i) across.push_back(static_cast<double>(i) / cells);
  add_block(mesh, across, {0.0, 1.0}, [&](double u, double v) {
    return Point{width * u, height * (v - 1.0)};
  });
  return mesh;
}

}  // namespace rebound::calculix
