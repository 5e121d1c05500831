#include "comparisons/config/impact_file.hpp"

#include <fmt/format.h>

#include <cmath>

#include "comparisons/config/describe_fem.hpp"
#include "comparisons/config/describe_lumped.hpp"
#include "comparisons/config/reader.hpp"
#include "comparisons/config/units.hpp"
#include "lumped/integration/composed_contact.hpp"
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

/// What the laws themselves demand of their parameters together, with the
/// place in the file added.
void check_parameters(const Document& document, const LumpedProblem& problem) {
  try {
    resolve_parameters(problem.model, problem.impact, problem.sphere);
  } catch (const Error& error) {
    throw document.located(error);
  }
  if (!problem.model.restitution && !problem.model.damping_formula.empty())
    throw document.error_at("model.damping_formula",
                            "a formula needs the restitution it is to reproduce");
}

void check_shares(const Document& document, const Material& material) {
  if (material.modulus != ModulusBasis::instantaneous) return;
  double sum = 0.0;
  for (std::size_t i = 0; i < material.branches.size(); ++i) {
    sum += material.branches[i].ratio;
    if (sum >= 1.0)
      throw document.error_at(
          fmt::format("model.material.branch[{}].ratio", i),
          fmt::format("the shares of the instantaneous modulus sum to {:.6g}, which leaves no "
                      "long-term modulus",
                      sum),
          "shares that sum below 1");
  }
}

/// A factor on the stress has an energy only where both moduli relax alike;
/// layers follow one another outward.
void check_inelastic(const Document& document, const Material& material) {
  if (material.strain != StrainDependence{})
    for (std::size_t i = 0; i < material.branches.size(); ++i)
      if (material.branches[i].relaxes == Relaxes::deviator)
        throw document.error_at(fmt::format("model.material.branch[{}].relaxes", i),
                                "factors of strain on the elastic stress have an energy only where "
                                "every branch relaxes all of the stress",
                                "all");
  for (std::size_t i = 1; i < material.layers.size(); ++i)
    if (material.layers[i].from <= material.layers[i - 1].from)
      throw document.error_at(fmt::format("model.material.layer[{}].from", i),
                              "layers stand from the inside outward",
                              fmt::format("above {:.6g}", material.layers[i - 1].from));
}

/// What the terms of an energy must be together; the solver holds the same.
void check_terms(const Document& document, const Material& material) {
  const bool foam = material.elastic == ElasticModel::hyperfoam;
  if (!foam && material.elastic != ElasticModel::ogden) return;
  constexpr std::size_t most = 6;
  if (material.terms.empty() || material.terms.size() > most)
    throw document.error_at("model.material.elastic",
                            fmt::format("this law has {} terms [[model.material.term]]",
                                        material.terms.size()),
                            fmt::format("1 to {} terms", most));
  double weights = 0.0, betas = 0.0, given = 0.0;
  for (std::size_t i = 0; i < material.terms.size(); ++i) {
    const StretchTerm& term = material.terms[i];
    if (term.exponent == 0.0)
      throw document.error_at(fmt::format("model.material.term[{}].exponent", i),
                              "an exponent of 0 has no energy", "-50 to 50, not 0");
    weights += term.weight;
    betas += term.weight * term.beta.value_or(0.0);
    given += term.beta ? 1.0 : 0.0;
  }
  if (!foam || given == 0.0) return;
  if (given < static_cast<double>(material.terms.size()))
    throw document.error_at("model.material.term[0]", "beta stands in some terms only",
                            "beta in every term or in none");
  const double mean = betas / weights, poisson_ratio = mean / (1.0 + 2.0 * mean);
  if (std::abs(poisson_ratio - material.poisson_ratio) > 0.002)
    throw document.error_at("model.material.poisson_ratio",
                            "the betas of the terms lead to another Poisson ratio",
                            fmt::format("{:.4g}, within 0.002", poisson_ratio));
}

/// Speed of shear waves before anything has relaxed.
double instantaneous_shear_speed(const FemProblem& problem) {
  const Material& material = problem.material;
  double modulus = 0.5 * material.youngs_modulus / (1.0 + material.poisson_ratio);
  if (material.modulus == ModulusBasis::long_term) {
    double ratios = 0.0;
    for (const PronyBranch& branch : material.branches) ratios += branch.ratio;
    modulus *= 1.0 + ratios;
  }
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

/// What the second scheme does not have.
void check_implicit(const Document& document, const FemProblem& problem) {
  const auto refuse = [&](const char* key, const char* what) {
    throw document.error_at(
        key, fmt::format("the implicit scheme has no {}; take scheme = \"explicit\"", what));
  };
  if (problem.plate.moves()) refuse("model.plate.stiffness", "plate that moves");
  if (problem.plate.friction != 0.0) refuse("model.plate.friction", "friction");
}

void check_fem(const Document& document, const FemProblem& problem) {
  if (problem.impact.separation != SeparationRule::zero_force)
    throw document.error_at("impact.separation",
                            "the FE tier finds separation by the force alone", "zero-force");
  check_material(document, problem.material);
  if (problem.scheme == FemScheme::implicit_steps) check_implicit(document, problem);
  const double wave = instantaneous_shear_speed(problem);
  if (problem.impact.speed >= wave)
    throw document.error_at(
        "impact.speed",
        fmt::format("the speed is {:.3g} times the shear wave speed of the ball, {:.3g} m/s; check "
                    "the units of speed, modulus ({:.3g} Pa), mass and diameter",
                    problem.impact.speed / wave, wave, problem.material.youngs_modulus),
        "speed below the shear wave speed");
  if (!problem.mesh_file.empty() && document.root()["model"]["cells"])
    throw document.error_at("model.cells", "the mesh file decides over the cells; give one of "
                                           "mesh and cells");
}

}  // namespace

void check_material(const Document& document, const Material& material) {
  constexpr double highest_poisson_ratio = 0.45;
  if (material.poisson_ratio > highest_poisson_ratio)
    throw document.error_at("model.material.poisson_ratio",
                            "fully integrated elements lock near incompressibility and would "
                            "give a wrong force",
                            "-1 < value <= 0.45");
  check_shares(document, material);
  check_terms(document, material);
  check_inelastic(document, material);
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

LumpedImpactFile read_lumped_impact(const Document& document) {
  check_tier(document, "lumped", "fem");
  LumpedImpactFile file;
  read_document(document, file);
  check_density(document, file.problem.sphere);
  check_plate(document);
  if (file.problem.model.mechanisms.plate.friction != 0.0)
    throw document.error_at("model.plate.friction",
                            "friction has no lumped form, a law's stiffness absorbs it; the FE "
                            "tier is where it belongs");
  check_parameters(document, file.problem);
  applied({.problem = file.problem, .effects = physical_effects(file.effects)}, document);
  return file;
}

FemImpactFile read_fem_impact(const Document& document) {
  check_tier(document, "fem", "lumped");
  FemImpactFile file;
  read_document(document, file);
  FemProblem& problem = file.problem;
  check_density(document, problem.sphere);
  check_plate(document);
  const std::filesystem::path mesh = problem.mesh_file;
  // Absolute, so that the effective configuration means the same file elsewhere.
  if (!mesh.empty()) problem.mesh_file = std::filesystem::absolute(document.folder() / mesh).string();
  check_fem(document, problem);
  applied({.problem = problem, .effects = physical_effects(file.effects)}, document);
  return file;
}

LumpedProblem applied(const LumpedImpactFile& file, const Document& document) {
  LumpedProblem problem = file.problem;
  try {
    apply_effects(file.effects, problem);
    if (problem.model.mechanisms.act()) ComposedContact{problem};  // can it be composed?
  } catch (const Error& error) {
    throw document.located(error);
  }
  return problem;
}

FemProblem applied(const FemImpactFile& file, const Document& document) {
  FemProblem problem = file.problem;
  try {
    apply_effects(file.effects, problem);
  } catch (const Error& error) {
    throw document.located(error);
  }
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
