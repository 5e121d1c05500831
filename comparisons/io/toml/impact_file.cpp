#include "comparisons/io/toml/impact_file.hpp"

#include <fmt/format.h>

#include <cmath>

#include "comparisons/io/toml/describe_fem.hpp"
#include "comparisons/io/toml/describe_lumped.hpp"
#include "comparisons/io/toml/reader.hpp"
#include "comparisons/io/toml/units.hpp"
#include "comparisons/models/fem_access/mesh_for.hpp"
#include "fem/interface/check_problem.hpp"
#include "fem/interface/engineering_moduli.hpp"
#include "lumped/integration/composed/composed_contact.hpp"
#include "lumped/laws/make_law.hpp"

namespace rebound {
namespace {

/// A file for the other tier would fail at its first model key; say instead
/// what is the matter.
void check_tier(const Document& document, const std::string& tier, const std::string& other) {
  const auto written = document.root()["model"]["tier"].value<std::string>();
  if (written == other)
    throw document.error_at(
        "model.tier", fmt::format("this file is for the {0} tier: run `rebound {0}` on it", other),
        tier);
}

/// Speed of shear waves before anything has relaxed.
double instantaneous_shear_speed(const FemProblem& problem) {
  const double modulus = fem::instantaneous_moduli(problem.material).shear;
  return std::sqrt(modulus / problem.sphere.density());
}

/// A plate's mass says nothing of a plate that stands still.
void check_plate(const Document& document) {
  const auto plate = document.root()["model"]["plate"];
  if (plate["stiffness"]) return;
  for (const char* key : {"mass", "damping_ratio"})
    if (plate[key])
      throw document.error_at(fmt::format("model.plate.{}", key),
                              "this belongs to a plate that moves: give its stiffness too");
}

void check_fem(const Document& document, const FemProblem& problem) {
  document.locating([&] { check(problem); });
  const double wave = instantaneous_shear_speed(problem);
  if (problem.impact.speed >= wave)
    throw document.error_at(
        "impact.speed",
        fmt::format("the speed is {:.3g} times the shear wave speed of the ball, {:.3g} m/s; check "
                    "the units of speed, modulus ({:.3g} Pa), mass and diameter",
                    problem.impact.speed / wave, wave, problem.material.youngs_modulus),
        "speed below the shear wave speed");
}

}  // namespace

void resolve_mesh(const Document& document, std::string& mesh_file) {
  if (mesh_file.empty()) return;
  if (!takes_cells(mesh_file) && document.root()["model"]["cells"])
    throw document.error_at("model.cells",
                            "the mesh file decides over the cells; give one of "
                            "mesh and cells");
  mesh_file = std::filesystem::absolute(document.folder() / mesh_file).string();
}

void check_density(const Document& document, const Sphere& sphere) {
  constexpr double lightest = 50.0;
  constexpr double heaviest = 20000.0;
  const double density = sphere.density();
  if (density >= lightest && density <= heaviest) return;
  throw document.error_at(
      "sphere.diameter",
      fmt::format("with the mass {} this implies a density of {:.3g} kg/m^3; check both units",
                  format_quantity(sphere.mass, "g"), density),
      "an implied density of 50 to 20000 kg/m^3");
}

LumpedProblem complete_impact(const Document& document, LumpedImpactFile& file) {
  check_density(document, file.problem.sphere);
  check_plate(document);
  document.locating(
      [&] { resolve_parameters(file.problem.model, file.problem.impact, file.problem.sphere); });
  return applied({.problem = file.problem, .effects = physical_effects(file.effects)}, document);
}

FemProblem complete_impact(const Document& document, FemImpactFile& file) {
  FemProblem& problem = file.problem;
  check_density(document, problem.sphere);
  check_plate(document);
  resolve_mesh(document, problem.mesh_file);
  check_fem(document, problem);
  return applied({.problem = problem, .effects = physical_effects(file.effects)}, document);
}

LumpedImpactFile read_lumped_impact(const Document& document) {
  check_tier(document, "lumped", "fem");
  LumpedImpactFile file;
  read_document(document, file);
  complete_impact(document, file);
  return file;
}

FemImpactFile read_fem_impact(const Document& document) {
  check_tier(document, "fem", "lumped");
  FemImpactFile file;
  read_document(document, file);
  complete_impact(document, file);
  return file;
}

LumpedProblem applied(const LumpedImpactFile& file, const Document& document) {
  LumpedProblem problem = file.problem;
  document.locating([&] {
    apply_effects(file.effects, problem);
    if (problem.model.mechanisms.act()) ComposedContact{problem};  // can it be composed?
  });
  return problem;
}

FemProblem applied(const FemImpactFile& file, const Document& document) {
  FemProblem problem = file.problem;
  document.locating([&] { apply_effects(file.effects, problem); });
  check_fem(document, problem);
  return problem;
}

LumpedProblem read_lumped_problem(const Document& document) {
  return applied(read_lumped_impact(document), document);
}

FemProblem read_fem_problem(const Document& document) {
  return applied(read_fem_impact(document), document);
}

LumpedProblem read_lumped_file(const std::filesystem::path& file) {
  return read_lumped_problem(Document::load(file));
}

FemProblem read_fem_file(const std::filesystem::path& file) {
  return read_fem_problem(Document::load(file));
}

}  // namespace rebound
