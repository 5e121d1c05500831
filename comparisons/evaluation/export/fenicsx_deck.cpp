#include <fmt/format.h>

#include <algorithm>

#include "comparisons/evaluation/export/deck_writers.hpp"
#include "comparisons/evaluation/export/sector.hpp"
#include "fem/interface/check_problem.hpp"
#include "fem/interface/elastic_models.hpp"
#include "fem/interface/engineering_moduli.hpp"

namespace rebound {
namespace {

constexpr const char* solver =
#include "comparisons/evaluation/export/fenicsx_solver.inc"
    ;

/// Penalty of the deck over that of other codes: Newton's method bears it there.
constexpr double stiffer = 4.0;
/// α of Hilber, Hughes and Taylor. A volume hundreds of times as stiff as the shape rings
/// faster than a step, and at -0.05 that grows until cells are turned inside out.
constexpr double alpha = -0.05, alpha_of_stiff_volume = -0.3;

/// energies(C): both parts of the stored energy in UFL, of the instantaneous moduli.
std::string law_lines(const SolidCard& solid, std::vector<std::string>& differences) {
  std::string text = fmt::format(
      "\n\ndef energies(C):\n    mu, K = {:.15g}, {:.15g}\n    J = ufl.sqrt(ufl.det(C))\n"
      "    log = ufl.ln(J)\n",
      solid.instantaneous.shear, solid.instantaneous.bulk);
  const std::string log_squares = "K / 4 * (J**2 - 1 - 2 * log)";
  const auto stretches = [&] {
    differences.push_back("two equal principal stretches are held apart by 1e-7");
    text +=
        "    mean, half = (C[0, 0] + C[1, 1]) / 2, (C[0, 0] - C[1, 1]) / 2\n"
        "    apart = ufl.sqrt(half**2 + C[0, 1]**2 + 1e-14)\n"
        "    squares = mean + apart, mean - apart, C[2, 2]\n    shape = 0\n";
  };
  switch (solid.elastic) {
    case ElasticModel::neo_hookean:
      return text +
             "    return (mu / 2 * (ufl.tr(C) - 3 - 2 * log) - mu / 3 * log**2, "
             "K / 2 * log**2)\n";
    case ElasticModel::neo_hookean_isochoric:
      return text + "    return mu / 2 * (J**(-2 / 3) * ufl.tr(C) - 3), K / 2 * (J - 1)**2\n";
    case ElasticModel::mooney_rivlin:
      return text + fmt::format(
                        "    first, second = ufl.tr(C), (ufl.tr(C)**2 - ufl.tr(C * C)) / 2\n"
                        "    return ({:.15g} * (J**(-2 / 3) * first - 3)\n"
                        "            + {:.15g} * (J**(-4 / 3) * second - 3)), {}\n",
                        solid.c10, solid.c01, log_squares);
    case ElasticModel::ogden:
      stretches();
      for (const StretchCard& term : solid.terms)
        text += fmt::format(
            "    shape += {0:.15g} * (J**{1:.15g} * sum(s**{2:.15g} for s in "
            "squares) - 3)\n",
            2.0 * term.shear / (term.exponent * term.exponent), -term.exponent / 3.0,
            0.5 * term.exponent);
      return text + "    return shape, " + log_squares + "\n";
    default:  // hyperfoam
      stretches();
      for (const StretchCard& term : solid.terms)
        text += fmt::format("    shape += {:.15g} * (sum(s**{:.15g} for s in squares) - 3 + {})\n",
                            2.0 * term.shear / (term.exponent * term.exponent), 0.5 * term.exponent,
                            term.beta == 0.0 ? fmt::format("{:.15g} * log", -term.exponent)
                                             : fmt::format("(J**{:.15g} - 1) / {:.15g}",
                                                           -term.exponent * term.beta, term.beta));
      return text + "    return shape - K / 2 * log**2, K / 2 * log**2\n";
  }
}

std::string numbers_of(const ImpactToExport& impact, bool mean_dilatation) {
  const FemProblem& problem = impact.problem;
  const double step = 0.5 * impact.interval;
  std::string branches;
  for (const RelaxingShare& branch : impact.solid.branches)
    branches += fmt::format("({:.15g}, {:.15g}, {:.15g}), ", branch.deviator, branch.volume,
                            branch.relaxation_time);
  return fmt::format(
      "\nimport numpy as np\nimport ufl\n\n"
      "MASS, RADIUS, SPEED, GRAVITY = {:.15g}, {:.15g}, {:.15g}, {:.15g}\n"
      "STEP, END, WINDOW = {:.15g}, {:.15g}, {:.15g}\n"
      "PENALTY = {:.15g}  # pressure over overclosure [Pa/m]\n"
      "ALPHA = {:g}\nTOLERANCE = {:.3g}  # of the residual [N]\n"
      "MEAN_DILATATION = {}\nBRANCHES = [{}]  # g of mu, k of K, tau\n",
      problem.sphere.mass, problem.sphere.radius(), problem.impact.speed, problem.gravity, step,
      impact.end_time,
      fem::expected_contact_time(problem, impact.solid.instantaneous) / fem::windows_per_contact,
      stiffer * impact.penalty, mean_dilatation ? alpha_of_stiff_volume : alpha,
      1e-9 * problem.sphere.mass * problem.impact.speed / step, mean_dilatation ? "True" : "False",
      branches);
}

/// Nine nodes a cell, in the order of Basix: corners and sides as a tensor product has them.
std::string mesh_lines(const QuadraticSection& section) {
  std::string nodes = "\nNODES = np.array([\n", cells = "CELLS = np.array([\n";
  for (const auto& p : section.nodes) nodes += fmt::format("    ({:.15g}, {:.15g}),\n", p[0], p[1]);
  std::size_t centre = section.nodes.size();
  for (const auto& cell : section.cells) {
    double r = 0.0, z = 0.0;
    for (int i = 0; i < 8; ++i) {
      const double weight = i < 4 ? -0.25 : 0.5;
      r += weight * section.nodes[cell[i]][0];
      z += weight * section.nodes[cell[i]][1];
    }
    nodes += fmt::format("    ({:.15g}, {:.15g}),\n", r, z);
    cells += fmt::format("    ({}, {}, {}, {}, {}, {}, {}, {}, {}),\n", cell[0], cell[1], cell[3],
                         cell[2], cell[4], cell[7], cell[5], cell[6], centre++);
  }
  return nodes + "])\n" + cells + "])\n";
}

}  // namespace

DeckBody fenicsx_deck(const ImpactToExport& impact) {
  const QuadraticSection section = quadratic_section(impact.mesh, impact.problem.sphere.radius());
  DeckBody body{.text = {},
                .nodes = static_cast<int>(section.nodes.size() + section.cells.size()),
                .elements = static_cast<int>(section.cells.size())};
  const bool mean_dilatation = fem::needs_mean_dilatation(impact.problem.material);
  body.text = numbers_of(impact, mean_dilatation) + law_lines(impact.solid, body.differences) +
              mesh_lines(section) + solver;
  return body;
}

}  // namespace rebound
