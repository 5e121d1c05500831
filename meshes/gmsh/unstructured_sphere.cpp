#include <gmsh.h>

#include <cmath>
#include <numbers>

#include "lumped/problem/error.hpp"
#include "meshes/gmsh/collect_mesh.hpp"
#include "meshes/gmsh/gmsh_session.hpp"
#include "meshes/gmsh/gmsh_work.hpp"
#include "meshes/quality/check_mesh.hpp"

namespace rebound {
namespace {

void name_group(int dimension, const std::vector<int>& members, const char* name) {
  const int group = gmsh::model::addPhysicalGroup(dimension, members);
  gmsh::model::setPhysicalName(dimension, group, name);
}

/// The half-disc, or its lower half, with its groups.
void make_geometry(double radius, SpherePart part) {
  namespace geo = gmsh::model::geo;
  const int pole = geo::addPoint(0, 0, 0), centre = geo::addPoint(0, radius, 0);
  const int equator = geo::addPoint(radius, radius, 0);
  const int lower_arc = geo::addCircleArc(pole, centre, equator);
  const int lower_axis = geo::addLine(centre, pole);
  std::vector<int> loop = {lower_arc}, axis = {lower_axis}, contact = {lower_arc};
  if (part == SpherePart::whole) {
    const int top = geo::addPoint(0, 2 * radius, 0);
    contact.push_back(geo::addCircleArc(equator, centre, top));
    axis.push_back(geo::addLine(top, centre));
    loop.insert(loop.end(), {contact.back(), axis.back()});
  } else {
    loop.push_back(geo::addLine(equator, centre));
  }
  loop.push_back(lower_axis);
  const int surface = geo::addPlaneSurface({geo::addCurveLoop(loop)});
  geo::synchronize();
  name_group(1, axis, "axis");
  name_group(1, contact, "contact");
  name_group(2, {surface}, "sphere");
}

/// `size` at the pole, growing with the distance from it.
Mesh mesh_with(const SphereMeshRequest& request, double size) {
  gmsh::clear();
  gmsh::model::add("sphere");
  make_geometry(request.radius, request.part);
  const double growth = (request.grading - 1.0) / (2.0 * request.radius);
  gmsh::model::mesh::setSizeCallback([=](int, int, double r, double z, double) {
    return size * (1.0 + growth * std::hypot(r, z));
  });
  gmsh::model::mesh::generate(2);
  gmsh::model::mesh::removeSizeCallback();
  return collect_mesh("", Coordinates::computed);
}

void check(const SphereMeshRequest& request) {
  constexpr double largest_grading = 100.0;
  const auto refuse = [](const char* key, double value, const char* allowed) {
    throw Error(ExitCode::bad_input, std::string("sphere mesh: ") + key + " is out of range",
                {.key = key, .value = std::to_string(value), .allowed = allowed});
  };
  if (!(request.radius > 0.0 && std::isfinite(request.radius)))
    refuse("radius", request.radius, "> 0 m");
  if (request.cells < 20) refuse("cells", request.cells, ">= 20");
  if (!(request.grading >= 1.0 && request.grading <= largest_grading))
    refuse("grading", request.grading, "[1, 100]");
}

}  // namespace

Mesh unstructured_sphere(const SphereMeshRequest& request) {
  check(request);
  open_gmsh();
  set_meshing();
  gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 0);
  gmsh::option::setNumber("Mesh.MeshSizeFromPoints", 0);
  const double half = request.part == SpherePart::whole ? 1.0 : 0.5;
  const double area = 0.5 * half * std::numbers::pi * request.radius * request.radius;
  double size = std::sqrt(area / request.cells / request.grading);
  Mesh best;
  double smallest_miss = 1e300;
  for (int attempt = 0; attempt < 8 && smallest_miss > 0.05; ++attempt) {
    Mesh mesh = mesh_with(request, size);
    const double ratio = static_cast<double>(mesh.cells.size()) / request.cells;
    if (std::abs(ratio - 1.0) < smallest_miss) {
      smallest_miss = std::abs(ratio - 1.0);
      best = std::move(mesh);
    }
    // Damped after the first: the count jumps with the size, and full steps go to and fro.
    size *= std::pow(ratio, attempt == 0 ? 0.5 : 0.35);
  }
  check_mesh(best, "");
  return best;
}

}  // namespace rebound
