#include "meshes/generate/sphere_mesh.hpp"

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <unordered_map>

#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr int gmsh_line = 1;
constexpr int gmsh_quadrilateral = 3;
constexpr int frontal_delaunay_algorithm = 6;
constexpr int full_quad_recombination = 3;
constexpr double largest_grading = 100.0;  ///< beyond, the far cells cannot follow the shape

/// Gmsh keeps global state; this opens and closes it.
class GmshSession {
 public:
  GmshSession() {
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("General.NumThreads", 1);
    gmsh::option::setNumber("Mesh.Algorithm", frontal_delaunay_algorithm);
    gmsh::option::setNumber("Mesh.RecombineAll", 1);
    gmsh::option::setNumber("Mesh.RecombinationAlgorithm", full_quad_recombination);
    gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 0);
    gmsh::option::setNumber("Mesh.MeshSizeFromPoints", 0);
    gmsh::option::setNumber("Mesh.Smoothing", 10);
  }
  ~GmshSession() { gmsh::finalize(); }
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;
};

struct SizeField {
  double contact_size;
  double contact_radius;
  double grading;
  double diameter;

  double operator()(double r, double z) const {
    const double distance = std::hypot(r, z);
    const double beyond = std::max(0.0, distance - contact_radius) / (diameter - contact_radius);
    return contact_size * (1.0 + (grading - 1.0) * beyond);
  }
};

std::vector<std::array<int, 2>> edges_of_curves(const std::vector<int>& curves,
                                                const std::unordered_map<std::size_t, int>& index) {
  std::vector<std::array<int, 2>> edges;
  for (const int curve : curves) {
    std::vector<int> types;
    std::vector<std::vector<std::size_t>> elements;
    std::vector<std::vector<std::size_t>> nodes;
    gmsh::model::mesh::getElements(types, elements, nodes, 1, curve);
    for (std::size_t k = 0; k < types.size(); ++k) {
      if (types[k] != gmsh_line) continue;
      for (std::size_t i = 0; i + 1 < nodes[k].size(); i += 2)
        edges.push_back({index.at(nodes[k][i]), index.at(nodes[k][i + 1])});
    }
  }
  return edges;
}

double signed_area(const Mesh& mesh, const std::array<int, 4>& cell) {
  double twice = 0.0;
  for (int i = 0; i < 4; ++i) {
    const auto& a = mesh.vertices[cell[i]];
    const auto& b = mesh.vertices[cell[(i + 1) % 4]];
    twice += a[0] * b[1] - b[0] * a[1];
  }
  return 0.5 * twice;
}

Mesh collect(int surface, const std::vector<int>& axis, const std::vector<int>& contact) {
  Mesh mesh;
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> elements;
  std::vector<std::vector<std::size_t>> nodes;
  gmsh::model::mesh::getElements(types, elements, nodes, 2, surface);
  if (types.size() != 1 || types[0] != gmsh_quadrilateral)
    throw Error(ExitCode::solver_failed, "Gmsh left cells that are not quadrilaterals");
  std::vector<std::size_t> tags;
  std::vector<double> coordinates;
  std::vector<double> unused;
  gmsh::model::mesh::getNodes(tags, coordinates, unused, 2, surface, true, false);
  // By tag: Gmsh lists the corner points in an order that changes from call to call.
  std::vector<std::size_t> order(tags.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return tags[a] < tags[b]; });
  std::unordered_map<std::size_t, int> index;
  for (const std::size_t i : order) {
    if (!index.emplace(tags[i], static_cast<int>(mesh.vertices.size())).second) continue;
    // The axis is a constraint of the discretisation: exactly zero, not 1e-19.
    const double r = std::abs(coordinates[3 * i]) < 1e-12 ? 0.0 : coordinates[3 * i];
    mesh.vertices.push_back({r, coordinates[3 * i + 1]});
  }
  for (std::size_t i = 0; i + 3 < nodes[0].size(); i += 4) {
    std::array<int, 4> cell{};
    for (int k = 0; k < 4; ++k) cell[k] = index.at(nodes[0][i + k]);
    if (signed_area(mesh, cell) < 0.0) std::swap(cell[1], cell[3]);
    mesh.cells.push_back(cell);
  }
  mesh.axis_edges = edges_of_curves(axis, index);
  mesh.contact_edges = edges_of_curves(contact, index);
  return mesh;
}

Mesh mesh_with(const SphereMeshRequest& request, double contact_size) try {
  const GmshSession session;
  gmsh::model::add("sphere");
  const double radius = request.radius;
  namespace geo = gmsh::model::geo;
  const int pole = geo::addPoint(0, 0, 0);
  const int centre = geo::addPoint(0, radius, 0);
  const int equator = geo::addPoint(radius, radius, 0);
  const int top = geo::addPoint(0, 2 * radius, 0);
  const int lower = geo::addCircleArc(pole, centre, equator);
  const int upper = geo::addCircleArc(equator, centre, top);
  const int upper_axis = geo::addLine(top, centre);
  const int lower_axis = geo::addLine(centre, pole);
  const int loop = geo::addCurveLoop({lower, upper, upper_axis, lower_axis});
  const int surface = geo::addPlaneSurface({loop});
  geo::synchronize();

  const SizeField size{contact_size, request.contact_radius, request.grading, 2 * radius};
  gmsh::model::mesh::setSizeCallback(
      [size](int, int, double x, double y, double) { return size(x, y); });
  gmsh::model::mesh::generate(2);
  gmsh::model::mesh::removeSizeCallback();
  return collect(surface, {upper_axis, lower_axis}, {lower, upper});
} catch (const std::string& reason) {  // what Gmsh 4.8 throws
  throw Error(ExitCode::solver_failed, "Gmsh: " + reason);
}

void check(const SphereMeshRequest& request) {
  const auto refuse = [](const char* key, double value, const char* allowed) {
    throw Error(ExitCode::bad_input, std::string("sphere mesh: ") + key + " is out of range",
                {.key = key, .value = std::to_string(value), .allowed = allowed});
  };
  if (!(request.radius > 0 && std::isfinite(request.radius))) refuse("radius", request.radius, "> 0 m");
  if (request.cells < 20) refuse("cells", request.cells, ">= 20");
  if (!(request.grading >= 1 && request.grading <= largest_grading))
    refuse("grading", request.grading, "[1, 100]");
  if (!(request.contact_radius >= 0 && request.contact_radius < request.radius))
    refuse("contact_radius", request.contact_radius, ">= 0 and below the radius");
}

}  // namespace

Mesh generate_sphere_mesh(const SphereMeshRequest& given) {
  check(given);
  SphereMeshRequest request = given;
  if (request.contact_radius == 0.0) request.contact_radius = 0.5 * request.radius;

  double size = request.radius * std::sqrt(1.5 / request.cells) / std::sqrt(request.grading);
  Mesh best;
  double best_miss = 1e300;
  for (int attempt = 0; attempt < 8 && best_miss > 0.05; ++attempt) {
    Mesh mesh = mesh_with(request, size);
    const double ratio = static_cast<double>(mesh.cells.size()) / request.cells;
    if (std::abs(ratio - 1.0) < best_miss) {
      best_miss = std::abs(ratio - 1.0);
      best = std::move(mesh);
    }
    // Damped after the first: the count jumps with the size, and full steps go to and fro.
    size *= std::pow(ratio, attempt == 0 ? 0.5 : 0.35);
  }
  return best;
}

}  // namespace rebound
