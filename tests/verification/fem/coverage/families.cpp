#include "tests/verification/fem/coverage/families.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>

#include "comparisons/accuracy/numerical_error/reference_impact.hpp"
#include "comparisons/models/fem_access/mesh_for.hpp"
#include "comparisons/models/fem_access/module_loader.hpp"
#include "meshes/refine/refined_mesh.hpp"

namespace rebound {
namespace {

constexpr std::array judged_quantities = {"restitution", "kinetic_energy_loss_share",
                                          "peak_deflection_m", "peak_force_N",
                                          "contact_time_tail_s"};

using Families = std::vector<std::pair<std::string, FamilyValues>>;

/// Three meshes, the finest cut from the middle one; half the step on the middle one.
struct FineFamily {
  Mesh coarse, middle;
  bool halved = false;
};

Families run_fine_family(const FemProblem& problem, const FineFamily& family) {
  const double radius = problem.sphere.radius();
  const auto run = [&](const Mesh& mesh, double step) {
    FemProblem one = problem;
    one.controls.step_safety *= step;
    FemResult result = fem_tier().simulate(one, mesh, {});
    if (!result.incomplete_because.empty()) throw std::runtime_error(result.incomplete_because);
    return result;
  };
  const FemResult small = run(family.coarse, 1.0), medium = run(family.middle, 1.0),
                  fine = run(refined_mesh(family.middle, radius), 1.0),
                  halved = family.halved ? run(family.middle, 0.5) : medium;
  Families families;
  for (const ScalarOfResult& scalar : scalars_with_error())
    families.push_back({scalar.key,
                        {.coarse = scalar.value(small),
                         .middle = scalar.value(medium),
                         .fine = scalar.value(fine),
                         .halved = scalar.value(halved)}});
  return families;
}

Families truth_family(FemProblem problem, int cells) {
  problem.cells = cells;
  const Mesh coarse = mesh_for(problem);
  return run_fine_family(
      problem, {.coarse = coarse, .middle = refined_mesh(coarse, problem.sphere.radius())});
}

/// 40 cells graded to a small contact leave the rest of the ball too coarse: the middle mesh is
/// graded by itself.
Families nine_node_family(FemProblem problem, int cells) {
  problem.scheme = FemScheme::implicit_steps;
  problem.cells = cells;
  const Mesh coarse = mesh_for(problem);
  problem.cells = 4 * cells;
  return run_fine_family(problem, {.coarse = coarse, .middle = mesh_for(problem), .halved = true});
}

Families bilinear_family(FemProblem problem, int cells) {
  problem.cells = cells;
  const ReferenceImpact reference = run_reference(fem_tier(), problem, mesh_for(problem), {});
  Families families;
  for (std::size_t i = 0; i < reference.values.size(); ++i)
    families.push_back({scalars_with_error()[i].key, reference.values[i]});
  return families;
}

Families run_by_use(const PlannedFamily& family) {
  const auto& [row, problem] = family;
  if (row.use == FamilyUse::truth) return truth_family(problem, row.cells);
  if (row.use == FamilyUse::nine_node) return nine_node_family(problem, row.cells);
  return bilinear_family(problem, row.cells);
}

}  // namespace

std::vector<CoverageRow> run_family(const PlannedFamily& family) {
  std::vector<CoverageRow> rows;
  for (const auto& [key, values] : run_by_use(family)) {
    if (std::find(judged_quantities.begin(), judged_quantities.end(), std::string_view(key)) ==
        judged_quantities.end())
      continue;
    CoverageRow& row = rows.emplace_back(family.row);
    row.quantity = key;
    row.values = values;
  }
  return rows;
}

}  // namespace rebound
