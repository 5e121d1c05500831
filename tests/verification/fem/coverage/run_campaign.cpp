// Adds to a table of bars what it lacks: the families that `rebound fem --reference` runs, fine
// families that are the truth, and nine-node families that hold the truth.
//
//   build/coverage_campaign comparisons/accuracy/numerical_error/error_bars/coverage.csv
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <set>
#include <string_view>
#include <tuple>

#include "comparisons/accuracy/numerical_error/coverage.hpp"
#include "comparisons/accuracy/numerical_error/reference_impact.hpp"
#include "comparisons/models/fem_access/mesh_for.hpp"
#include "comparisons/models/fem_access/module_loader.hpp"
#include "fem/interface/check_problem.hpp"
#include "fem/interface/engineering_moduli.hpp"
#include "meshes/refine/refined_mesh.hpp"

namespace rebound {
namespace {

constexpr int points = 30;
constexpr std::array judged_quantities = {"restitution", "kinetic_energy_loss_share",
                                          "peak_deflection_m", "peak_force_N",
                                          "contact_time_tail_s"};

double halton(int index, int base) {
  double value = 0.0, digit = 1.0;
  for (; index > 0; index /= base) {
    digit /= base;
    value += digit * (index % base);
  }
  return value;
}

/// Speed evenly in its logarithm; a third of the balls nearly incompressible, a fifth elastic.
CoveragePoint point_of(int number) {
  const double speed = halton(number, 2), ratio = halton(number, 3), share = halton(number, 5);
  return {.speed = 0.0005 * std::pow(400.0, speed),
          .poisson_ratio =
              ratio < 0.7 ? 0.45 * ratio / 0.7 : 0.5 - 0.05 * std::pow(0.02, (ratio - 0.7) / 0.3),
          .branch_share = share < 0.2 ? 0.0 : share - 0.2,
          .branch_time = 0.05 * std::pow(40.0, halton(number, 7))};
}

FemProblem problem_of(const CoveragePoint& point) {
  FemProblem problem;
  problem.sphere = {.mass = 0.0896, .diameter = 0.0662};
  problem.material = {.youngs_modulus = 10e6, .poisson_ratio = point.poisson_ratio};
  const double density = problem.sphere.mass / problem.sphere.volume();
  problem.impact.speed = point.speed * std::sqrt(10e6 / density);
  if (point.branch_share > 0.0)
    problem.material.branches = {
        {point.branch_share,
         point.branch_time *
             fem::expected_contact_time(problem, fem::instantaneous_moduli(problem.material)),
         Relaxes::all}};
  return problem;
}

/// Cells of the coarsest mesh: of the families that are judged, and of the truth.
struct PlannedCells {
  std::vector<int> judged = {250, 300, 350, 420, 500, 600, 700};
  int truth = 2000, nine_node = 0;
};

PlannedCells cells_of(int number, const CoveragePoint& point) {
  PlannedCells plan;
  if (number % 6 == 0) {
    plan.judged.insert(plan.judged.end(), {1000, 1400});
    plan.truth = 4000;
    plan.nine_node = 40;
  }
  // The step of a ball that is stiff in volume is several times shorter.
  if (point.poisson_ratio > 0.47)
    plan = {.judged = {250, 280, 315, 350, 400, 450, 500}, .truth = 1400};
  return plan;
}

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

class Campaign {
 public:
  explicit Campaign(const std::filesystem::path& file) : file_(file) {
    if (!std::filesystem::exists(file)) {
      std::ofstream(file) << coverage_heading() << "\n";
      return;
    }
    for (const CoverageRow& row : read_coverage(file))
      done_.insert({row.number, row.use, row.cells});
  }

  void run(int number) {
    const CoveragePoint point = point_of(number);
    const FemProblem problem = problem_of(point);
    const PlannedCells plan = cells_of(number, point);
    add({.number = number, .point = point, .use = FamilyUse::truth, .cells = plan.truth},
        [&] { return truth_family(problem, plan.truth); });
    if (plan.nine_node > 0)
      add({.number = number, .point = point, .use = FamilyUse::nine_node, .cells = plan.nine_node},
          [&] { return nine_node_family(problem, plan.nine_node); });
    for (const int cells : plan.judged)
      add({.number = number, .point = point, .use = FamilyUse::bars, .cells = cells},
          [&] { return bilinear_family(problem, cells); });
  }

 private:
  template <class Run>
  void add(CoverageRow row, const Run& run) {
    if (done_.contains({row.number, row.use, row.cells})) return;
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    std::string text;
    try {
      for (const auto& [key, values] : run()) {
        if (std::find(judged_quantities.begin(), judged_quantities.end(), std::string_view(key)) ==
            judged_quantities.end())
          continue;
        row.quantity = key;
        row.values = values;
        text += to_csv(row);
      }
    } catch (const std::exception& error) {
      fmt::print(stderr, "point {}, {} cells: {}\n", row.number, row.cells, error.what());
      return;
    }
    std::ofstream(file_, std::ios::app) << text;
    fmt::print(stderr, "point {} of {}, {} cells: {:.1f} s\n", row.number, points, row.cells,
               std::chrono::duration<double>(Clock::now() - start).count());
  }

  std::filesystem::path file_;
  std::set<std::tuple<int, FamilyUse, int>> done_;
};

}  // namespace
}  // namespace rebound

int main(int count, char** arguments) try {
  if (count != 2) {
    fmt::print(stderr, "usage: coverage_campaign TABLE.csv\n");
    return 2;
  }
  rebound::Campaign campaign(arguments[1]);
  for (int number = 1; number <= rebound::points; ++number) campaign.run(number);
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "{}\n", error.what());
  return 3;
}
