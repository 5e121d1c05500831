#include "fem/implicit/quadratic_body.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <utility>

#include "lumped/problem/error.hpp"

namespace rebound::fem {
namespace {

using Edge = std::pair<int, int>;
using Place = std::array<double, 2>;

Edge key(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

[[noreturn]] void refuse(const std::string& why) {
  throw Error(ExitCode::bad_input, "mesh refused: " + why, {.key = "model.mesh"});
}

class BodyBuilder {
 public:
  BodyBuilder(const Mesh& mesh, const QuadraticRequest& request) : mesh_(mesh), request_(request) {
    if (mesh.cells.empty()) refuse("it has no cells");
    if (mesh.contact_edges.empty()) refuse("it has no edges in the group \"contact\"");
    for (const auto& vertex : mesh.vertices)
      if (vertex[0] < 0.0) refuse("a vertex lies at negative radius");
    corner_.assign(mesh.vertices.size(), -1);
    for (const auto& edge : mesh.contact_edges) contact_edges_.insert(key(edge[0], edge[1]));
  }

  QuadraticBody build() {
    for (const auto& cell : mesh_.cells) add(cell);
    find_axis();
    find_contact();
    double volume = 0.0;
    for (const auto& cell : body_.cells)
      for (const auto& point : cell.points) volume += point.weight;
    body_.mass = request_.mass;
    body_.density = request_.mass / volume;
    for (const auto& p : body_.position) body_.height = std::max(body_.height, p[1]);
    return std::move(body_);
  }

 private:
  int add_node(const Place& place) {
    body_.position.push_back(place);
    return static_cast<int>(body_.position.size()) - 1;
  }
  int corner(int vertex) {
    if (vertex < 0 || vertex >= static_cast<int>(corner_.size()))
      refuse("a cell names a vertex that does not exist");
    if (corner_[vertex] < 0) corner_[vertex] = add_node(mesh_.vertices[vertex]);
    return corner_[vertex];
  }
  bool on_sphere(int vertex) const {
    constexpr double tolerance = 1e-6;  // of the radius; files keep fewer digits
    const double radius = request_.radius;
    const auto& [r, z] = mesh_.vertices[vertex];
    return radius > 0.0 && std::abs(std::hypot(r, z - radius) - radius) <= tolerance * radius;
  }
  int middle(int a, int b) {
    const auto known = middles_.find(key(a, b));
    if (known != middles_.end()) return known->second;
    Place place;
    for (int k = 0; k < 2; ++k) place[k] = 0.5 * (mesh_.vertices[a][k] + mesh_.vertices[b][k]);
    if (contact_edges_.contains(key(a, b)) && on_sphere(a) && on_sphere(b)) {
      const double radius = request_.radius;
      const double scale = radius / std::hypot(place[0], place[1] - radius);
      place = {place[0] * scale, radius + scale * (place[1] - radius)};
    }
    return middles_[key(a, b)] = add_node(place);
  }
  void add(const std::array<int, 4>& vertices);
  void find_axis();
  void find_contact();
  /// The side that leads inwards from contact vertex `v`, and what lies at its far end.
  void look_behind(const std::array<int, 4>& vertices);

  struct Inward {
    double slope = -std::numeric_limits<double>::infinity();
    std::array<int, 2> nodes{};
  };
  void offer(int node, int first, int second, const Place& into);

  const Mesh& mesh_;
  const QuadraticRequest& request_;
  QuadraticBody body_;
  std::vector<int> corner_;
  std::map<Edge, int> middles_;
  std::set<Edge> contact_edges_;
  std::map<int, Place> normal_;    ///< into the body, by contact node
  std::map<int, Inward> inward_;
};

void BodyBuilder::add(const std::array<int, 4>& vertices) {
  QuadraticCell cell;
  Place centre{};
  for (int i = 0; i < 4; ++i) {
    cell.nodes[i] = corner(vertices[i]);
    cell.nodes[4 + i] = middle(vertices[i], vertices[(i + 1) % 4]);
  }
  for (int k = 0; k < 2; ++k)
    for (int i = 0; i < 4; ++i)  // transfinite: follows a curved side
      centre[k] += 0.5 * body_.position[cell.nodes[4 + i]][k] - 0.25 * body_.position[cell.nodes[i]][k];
  cell.nodes[8] = add_node(centre);

  constexpr double gauss[3] = {-0.77459666924148337704, 0.0, 0.77459666924148337704};
  constexpr double share[3] = {5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};
  for (int q = 0; q < quadratic_points; ++q) {
    const QuadraticShapes shapes(gauss[q % 3], gauss[q / 3]);
    auto& point = cell.points[q];
    point.shape = shapes.value;
    double map[2][2] = {};
    for (int i = 0; i < quadratic_nodes; ++i) {
      const auto& x = body_.position[cell.nodes[i]];
      point.radius += shapes.value[i] * x[0];
      for (int k = 0; k < 2; ++k)
        for (int s = 0; s < 2; ++s) map[k][s] += x[k] * shapes.slope[i][s];
    }
    const double det = map[0][0] * map[1][1] - map[0][1] * map[1][0];
    if (!(det > 0.0)) refuse("a cell is inverted or has no area");
    for (int i = 0; i < quadratic_nodes; ++i) {
      const auto& s = shapes.slope[i];
      point.gradient[i] = {(s[0] * map[1][1] - s[1] * map[1][0]) / det,
                           (s[1] * map[0][0] - s[0] * map[0][1]) / det};
    }
    point.weight = 2.0 * std::numbers::pi * point.radius * det * share[q % 3] * share[q / 3];
  }
  body_.cells.push_back(cell);
}

void BodyBuilder::find_axis() {
  std::set<int> axis;
  for (const auto& edge : mesh_.axis_edges)
    for (const int node : {corner(edge[0]), corner(edge[1]), middle(edge[0], edge[1])})
      axis.insert(node);
  double reach = 0.0;
  for (const auto& p : body_.position) reach = std::max(reach, std::hypot(p[0], p[1]));
  for (int node = 0; node < body_.node_count(); ++node)
    if ((body_.position[node][0] <= 1e-9 * reach) != axis.contains(node))
      refuse("the group \"axis\" and the vertices at radius 0 are not the same");
  body_.axis_nodes.assign(axis.begin(), axis.end());
}

void BodyBuilder::offer(int node, int first, int second, const Place& into) {
  const auto& from = body_.position[node];
  const auto& to = body_.position[second];
  const double dr = to[0] - from[0], dz = to[1] - from[1];
  const double slope = (dr * into[0] + dz * into[1]) / std::hypot(dr, dz);
  Inward& best = inward_[node];
  if (slope > best.slope) best = {slope, {first, second}};
}

void BodyBuilder::look_behind(const std::array<int, 4>& vertices) {
  const auto& nodes = body_.cells[&vertices - mesh_.cells.data()].nodes;
  for (int i = 0; i < 4; ++i) {
    const int next = (i + 1) % 4, before = (i + 3) % 4;
    if (contact_edges_.contains(key(vertices[i], vertices[next])))
      offer(nodes[4 + i], nodes[8], nodes[4 + (i + 2) % 4], normal_.at(nodes[4 + i]));
    const auto at = normal_.find(nodes[i]);
    if (at == normal_.end()) continue;
    const bool forward = contact_edges_.contains(key(vertices[i], vertices[next]));
    const bool backward = contact_edges_.contains(key(vertices[i], vertices[before]));
    if (!forward) offer(nodes[i], nodes[4 + i], nodes[next], at->second);
    if (!backward) offer(nodes[i], nodes[4 + before], nodes[before], at->second);
    if (forward && backward) offer(nodes[i], nodes[8], nodes[(i + 2) % 4], at->second);
  }
}

void BodyBuilder::find_contact() {
  // Cells are counter-clockwise: the body is to the left of its own edges.
  for (const auto& vertices : mesh_.cells)
    for (int i = 0; i < 4; ++i) {
      const int a = vertices[i], b = vertices[(i + 1) % 4];
      if (!contact_edges_.contains(key(a, b))) continue;
      const auto& from = mesh_.vertices[a];
      const auto& to = mesh_.vertices[b];
      body_.contact_sides.push_back({corner_[a], corner_[b], middle(a, b)});
      for (const int node : body_.contact_sides.back()) {
        normal_[node][0] -= to[1] - from[1];
        normal_[node][1] += to[0] - from[0];
      }
    }
  if (normal_.empty()) refuse("no edge of the group \"contact\" belongs to a cell");
  for (const auto& vertices : mesh_.cells) look_behind(vertices);
  for (const auto& [node, inward] : inward_) body_.contact.push_back({node, inward.nodes});
  std::sort(body_.contact.begin(), body_.contact.end(), [&](const auto& a, const auto& b) {
    return body_.position[a.node] < body_.position[b.node];
  });
}

}  // namespace

QuadraticBody quadratic_body(const Mesh& mesh, const QuadraticRequest& request) {
  return BodyBuilder(mesh, request).build();
}

}  // namespace rebound::fem
