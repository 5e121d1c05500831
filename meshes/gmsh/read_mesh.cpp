#include <gmsh.h>

#include <algorithm>
#include <cmath>

#include "lumped/problem/error.hpp"
#include "meshes/gmsh/collect_mesh.hpp"
#include "meshes/gmsh/gmsh_session.hpp"
#include "meshes/gmsh/gmsh_work.hpp"
#include "meshes/quality/check_mesh.hpp"

namespace rebound {
namespace {

/// Errors of a script stand in the log alone: the parser goes on after them.
void refuse_logged_errors(const std::string& file) {
  std::vector<std::string> log;
  gmsh::logger::get(log);
  for (const std::string& line : log)
    if (line.starts_with("Error"))
      throw Error(ExitCode::bad_input, "Gmsh: " + line, {.file = file});
}

void mesh_script(const InputFile& input, const std::string& path) {
  set_meshing();
  gmsh::merge(path);
  refuse_logged_errors(input.name);
  gmsh::vectorpair surfaces;
  gmsh::model::getEntities(surfaces, 2);
  if (surfaces.empty())
    throw Error(ExitCode::bad_input, "the geometry has no surface to be meshed",
                {.file = input.name});
  gmsh::option::setNumber("Mesh.RecombineAll", 1);
  gmsh::option::setNumber("Mesh.ElementOrder", 1);
  gmsh::model::mesh::generate(2);
}

/// Curves at r = 0, and the others that bound one surface only, as groups.
void name_groups() {
  gmsh::vectorpair curves;
  gmsh::model::getEntities(curves, 1);
  double x0, y0, z0, x1, y1, z1;
  gmsh::model::getBoundingBox(-1, -1, x0, y0, z0, x1, y1, z1);
  // OpenCASCADE's boxes are a little too large.
  const double near = 1e-5 * std::max(x1 - x0, y1 - y0);
  std::vector<int> axis, contact;
  for (const auto& [dimension, curve] : curves) {
    std::vector<int> upward, downward;
    gmsh::model::getAdjacencies(1, curve, upward, downward);
    if (upward.size() != 1) continue;
    gmsh::model::getBoundingBox(1, curve, x0, y0, z0, x1, y1, z1);
    (std::max(std::abs(x0), std::abs(x1)) <= near ? axis : contact).push_back(curve);
  }
  const auto add = [](const std::vector<int>& members, const char* name) {
    if (!members.empty())
      gmsh::model::setPhysicalName(1, gmsh::model::addPhysicalGroup(1, members), name);
  };
  add(axis, "axis");
  add(contact, "contact");
}

double area_of(const gmsh::vectorpair& surfaces) {
  double sum = 0.0;
  for (const auto& [dimension, surface] : surfaces) {
    double area = 0.0;
    gmsh::model::occ::getMass(2, surface, area);
    sum += area;
  }
  return sum;
}

void mesh_geometry(const InputFile& input, const std::string& path, int cells) {
  gmsh::vectorpair shapes, surfaces, solids;
  gmsh::model::occ::importShapes(path, shapes, false, "step");
  gmsh::model::occ::synchronize();
  gmsh::model::getEntities(solids, 3);
  if (!solids.empty())
    throw Error(ExitCode::bad_input,
                "the geometry is a solid; half the ball's section is needed, a surface in x "
                "(radius) and y (height)",
                {.file = input.name});
  gmsh::model::getEntities(surfaces, 2);
  const double area = area_of(surfaces);
  if (surfaces.empty() || !(area > 0.0))
    throw Error(ExitCode::bad_input, "the geometry has no surface to be meshed",
                {.file = input.name});
  name_groups();
  set_meshing();
  const double size = 1.2 * std::sqrt(area / cells);
  gmsh::option::setNumber("Mesh.MeshSizeMin", size);
  gmsh::option::setNumber("Mesh.MeshSizeMax", size);
  gmsh::model::mesh::generate(2);
}

}  // namespace

Mesh read_through_gmsh(const InputFile& input, const std::string& path, int cells) {
  open_gmsh();
  gmsh::logger::start();
  const auto mesh_with = [&] {
    switch (input.kind) {
      case InputKind::mesh: gmsh::merge(path); break;
      case InputKind::script: mesh_script(input, path); break;
      case InputKind::geometry: mesh_geometry(input, path, cells); break;
    }
    refuse_logged_errors(input.name);
  };
  try {
    mesh_with();
  } catch (const std::string& reason) {  // what Gmsh 4.8 throws
    throw Error(ExitCode::bad_input, "Gmsh: " + reason, {.file = input.name});
  }
  Mesh mesh = collect_mesh(
      input.name, input.kind == InputKind::mesh ? Coordinates::given : Coordinates::computed);
  check_mesh(mesh, input.name);
  return mesh;
}

}  // namespace rebound
