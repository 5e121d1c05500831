#include "comparisons/models/fem_access/mesh_for.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "comparisons/models/fem_access/memory_needed.hpp"
#include "comparisons/models/fem_access/module_loader.hpp"
#include "fem/interface/check_problem.hpp"
#include "fem/interface/engineering_moduli.hpp"
#include "lumped/problem/error.hpp"
#include "meshes/generate/sphere_mesh.hpp"
#include "meshes/quality/mesh_quality.hpp"

namespace rebound {
namespace {

/// A user's mesh in millimetres, or of another ball, would run and mislead.
void check_size(const Sphere& sphere, SpherePart part, const Mesh& mesh, const std::string& file) {
  constexpr double tolerance = 0.05;  // straight cell edges cut some off
  const bool half = part == SpherePart::lower_half;
  const char* body = half ? "the lower half of the sphere" : "the sphere";
  const auto check = [&](const char* what, double found, double wanted, const char* unit) {
    if (std::abs(found / wanted - 1.0) <= tolerance) return;
    throw Error(ExitCode::bad_input,
                fmt::format("the mesh turned about its axis has a {0} of {1:.4g} {2}, {3} of "
                            "sphere.diameter {4:.4g} {2}; coordinates are in metres",
                            what, found, unit, body, wanted),
                {.file = file,
                 .key = "model.mesh",
                 .value = file,
                 .allowed = fmt::format("a {} within 5 %", what)});
  };
  double highest = 0.0;
  for (const auto& vertex : mesh.vertices) highest = std::max(highest, vertex[1]);
  check("volume", measure_quality(mesh).volume, (half ? 0.5 : 1.0) * sphere.volume(), "m^3");
  check("height", highest, (half ? 0.5 : 1.0) * sphere.diameter, "m");
}

/// Of the stiffest layer before anything has relaxed: the smallest contact there can be.
double contact_over_radius(const FemProblem& problem) {
  fem::Moduli stiffest = fem::instantaneous_moduli(problem.material);
  double factor = 1.0;
  for (const RadialLayer& layer : problem.material.layers)
    factor = std::max(factor, layer.modulus_factor);
  stiffest = {.shear = factor * stiffest.shear, .bulk = factor * stiffest.bulk};
  return fem::expected_contact_radius(problem, stiffest) / problem.sphere.radius();
}

Mesh own_mesh(const Sphere& sphere, SpherePart part, const std::string& file, int cells,
              const RunControl& control) {
  Mesh mesh = gmsh_module().read(file, cells, {.interrupted = control.interrupted, .progress = {}});
  check_size(sphere, part, mesh, file);
  return mesh;
}

}  // namespace

Mesh mesh_for(const FemProblem& problem, const RunControl& control, int copies) {
  if (!problem.mesh_file.empty()) {
    Mesh mesh =
        own_mesh(problem.sphere, SpherePart::whole, problem.mesh_file, problem.cells, control);
    check_memory(problem, copies * static_cast<int>(mesh.cells.size()));
    return mesh;
  }
  check_memory(problem, copies * problem.cells);
  return generate_sphere_mesh(
      {.radius = problem.sphere.radius(),
       .cells = problem.cells,
       .grading = grading_for_contact(problem.cells, contact_over_radius(problem))});
}

Mesh mesh_for(const CompressionProblem& problem, const RunControl& control) {
  const bool half = problem.compression.platens == 2;
  const SpherePart part = half ? SpherePart::lower_half : SpherePart::whole;
  if (!problem.mesh_file.empty())
    return own_mesh(problem.sphere, part, problem.mesh_file, problem.cells, control);
  const double radius = problem.sphere.radius();
  const double approach = problem.compression.deflection * (half ? 0.5 : 1.0);
  return generate_sphere_mesh({.radius = radius,
                               .cells = problem.cells,
                               .grading = std::clamp(0.3 * radius / approach, 1.5, 200.0),
                               .part = part});
}

bool takes_cells(const std::string& mesh_file) {
  std::string ending = mesh_file.substr(std::min(mesh_file.size(), mesh_file.rfind('.')));
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return mesh_file.empty() || ending == ".step" || ending == ".stp";
}

}  // namespace rebound
