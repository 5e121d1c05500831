#include "comparisons/evaluation/export/export_deck.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "comparisons/io/toml/nearest_key.hpp"
#include "fem/interface/check_problem.hpp"
#include "fem/interface/elastic_models.hpp"
#include "fem/interface/engineering_moduli.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// Radius over the overclosure at a pressure of E*. CalculiX moves its deflection by 0.02 % from
/// 3000 to 8000, and stays where it converges.
constexpr double penalty_number = 8000.0;
constexpr double contact_times = 1.25;  ///< of Hertz, that a deck lasts
constexpr double outputs = 200.0;       ///< over the Hertz contact time

[[noreturn]] void refuse(const ExportTarget& target, const std::string& what,
                         ErrorLocation location) {
  throw Error(
      ExitCode::bad_input,
      fmt::format("{} would lose {}, and the deck would be another problem", target.code, what),
      std::move(location));
}

void refuse_number(const ExportTarget& target, const char* key, double value, const char* what) {
  if (value != 0.0) refuse(target, what, {.key = key, .value = number_text(value)});
}

void refuse_lost_material(const ExportTarget& target, const Material& material) {
  const auto lost = [&](const char* key, double value, const char* what) {
    refuse_number(target, key, value, what);
  };
  lost("model.material.strain_stiffening", material.strain.stiffening, "the factor of strain");
  lost("model.material.strain_softening", material.strain.softening, "the factor of strain");
  lost("model.material.densification", material.strain.densification, "the factor of strain");
  lost("model.material.strain_curve", material.strain.curve.reach, "the factor of strain");
  lost("model.material.unloading_curve", material.strain.unloading.acts() ? 1.0 : 0.0,
       "the factor of strain");
  lost("model.material.mullins", material.strain.mullins, "Mullins softening");
  lost("model.material.retardation_time", material.retardation_time, "the viscous stress");
  for (const PronyBranch& branch : material.branches)
    if (branch.rate_exponent != 1.0)
      refuse(target, "the flow of a branch by a power of its rate",
             {.key = "model.material.branch.rate_exponent",
              .value = number_text(branch.rate_exponent),
              .allowed = "1"});
  if (!material.branches.empty() && material.relaxation == Relaxation::multiplicative)
    refuse(target, "branches by the multiplicative split",
           {.key = "model.material.relaxation",
            .value = name_of(material.relaxation),
            .allowed = name_of(Relaxation::convolution)});
  if (!material.layers.empty())
    refuse(target, "layers", {.key = "model.material.layer", .value = "given"});
}

void refuse_lost_physics(const ExportTarget& target, const FemProblem& problem) {
  const auto carries = [&](CarriedPhysics physics) {
    return std::find(target.carries.begin(), target.carries.end(), physics) != target.carries.end();
  };
  refuse_lost_material(target, problem.material);
  if (!problem.material.branches.empty() && !carries(CarriedPhysics::relaxation))
    refuse(target, "relaxation: the code has no Prony series at finite strain",
           {.key = "model.material.branch", .value = "given"});
  refuse_number(target, "model.adhesion.work", problem.adhesion.work, "adhesion");
  if (problem.plate.moves())
    refuse(target, "the plate that moves",
           {.key = "model.plate.stiffness", .value = number_text(problem.plate.stiffness)});
  if (!carries(CarriedPhysics::friction))
    refuse_number(target, "model.plate.friction", problem.plate.friction, "friction");
  if (!carries(CarriedPhysics::gravity))
    refuse_number(target, "impact.gravity", problem.gravity, "gravity");
}

std::string comment(const ExportTarget& target, const std::string& line) {
  return *target.comment != '\0' ? fmt::format("{} {}\n", target.comment, line)
                                 : fmt::format("  {}\n", line);
}

std::string head(const ExportTarget& target, const FemProblem& problem, const ExportedDeck& deck) {
  std::vector<std::string> lines = {
      fmt::format("Rebound: impact of a ball on a rigid plate, deck for {}", target.code),
      fmt::format("ball {:.12g} kg, diameter {:.12g} m; speed {:.12g} m/s towards the plate",
                  problem.sphere.mass, problem.sphere.diameter, problem.impact.speed),
      fmt::format("material {}: E {:.12g} Pa, Poisson ratio {:.12g} ({}), {} Prony branches",
                  name_of(problem.material.elastic), problem.material.youngs_modulus,
                  problem.material.poisson_ratio, name_of(problem.material.modulus),
                  problem.material.branches.size()),
      fmt::format("{} elements, {} nodes; SI units throughout; ends at {:.6g} s", deck.elements,
                  deck.nodes, deck.end_time),
      "Not carried over as Rebound computes it:"};
  for (const std::string& difference : deck.differences) lines.push_back("- " + difference);
  std::string text;
  for (const std::string& line : lines) text += comment(target, line);
  return *target.comment != '\0'
             ? text
             : "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!--\n" + text + "-->\n";
}

}  // namespace

const ExportTarget& export_target(const std::string& name) {
  std::vector<std::string> names;
  for (const ExportTarget& target : export_targets()) {
    if (target.name == name) return target;
    names.emplace_back(target.name);
  }
  const std::string near = nearest_key(name, names);
  throw Error(ExitCode::bad_input,
              "no deck is written for a code of this name" +
                  (near.empty() ? near : fmt::format("; did you mean {}?", near)),
              {.key = "--to", .value = name, .allowed = fmt::format("{}", fmt::join(names, ", "))});
}

ExportedDeck export_deck(const ExportTarget& target, const FemProblem& problem, const Mesh& mesh) {
  check(problem);
  refuse_lost_physics(target, problem);
  const SolidCard solid = solid_card(problem.material);
  const double contact_time = fem::expected_contact_time(problem, solid.instantaneous);
  const FemControls& controls = problem.controls;
  ImpactToExport impact{
      .problem = problem,
      .mesh = mesh,
      .solid = solid,
      .end_time = controls.end_time > 0.0
                      ? controls.end_time
                      : contact_times * fem::expected_contact_time(problem, solid.long_term),
      .interval =
          controls.output_interval > 0.0 ? controls.output_interval : contact_time / outputs,
      .penalty = penalty_number * fem::plane_strain_modulus(solid.instantaneous) /
                 problem.sphere.radius()};
  DeckBody body = target.write(impact);
  ExportedDeck deck{.differences = target.always_different,
                    .nodes = body.nodes,
                    .elements = body.elements,
                    .end_time = impact.end_time};
  deck.differences.insert(deck.differences.end(), body.differences.begin(), body.differences.end());
  deck.text = head(target, problem, deck) + body.text;
  return deck;
}

}  // namespace rebound
