#include "tests/verification/fem/coverage/plan.hpp"

#include <cmath>

#include "fem/interface/check_problem.hpp"
#include "fem/interface/engineering_moduli.hpp"

namespace rebound {
namespace {

constexpr int points = 30, rubber_points = 6;

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

/// Nearly incompressible balls at speeds whose families take seconds: half of the points above a
/// ratio of 0.45 that point_of() gives are slow and stiff, and take an hour each.
CoveragePoint rubber_point_of(int number) {
  const double share = halton(number, 5);
  return {.speed = 0.01 * std::pow(20.0, halton(number, 2)),
          .poisson_ratio = 0.5 - 0.05 * std::pow(0.1, halton(number, 3)),
          .branch_share = share < 0.4 ? 0.0 : share - 0.2,
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
  if (number <= points && number % 6 == 0) {
    plan.judged.insert(plan.judged.end(), {1000, 1400});
    plan.truth = 4000;
    plan.nine_node = 40;
  }
  // Of fast balls that are not stiff in volume a family of many cells takes a minute.
  if (number <= points && point.speed > 0.05 && point.poisson_ratio <= 0.45) {
    plan.judged.insert(plan.judged.end(), {2000, 4000});
    plan.truth = 12000;
  }
  // The step of a ball that is stiff in volume is several times shorter.
  if (point.poisson_ratio > 0.47)
    plan = {.judged = {250, 280, 315, 350, 400, 450, 500}, .truth = 1400};
  // An elastic ball loses so little that the error of a coarser truth would be taken for that of
  // the bars.
  if (point.poisson_ratio > 0.45 && point.branch_share == 0.0) plan.truth = 5600;
  return plan;
}

void append(std::vector<PlannedFamily>& families, int number, const CoveragePoint& point,
            const PlannedCells& cells) {
  const FemProblem problem = problem_of(point);
  const auto add = [&](FamilyUse use, int coarsest) {
    PlannedFamily& family = families.emplace_back();
    family.row.number = number;
    family.row.point = point;
    family.row.use = use;
    family.row.cells = coarsest;
    family.problem = problem;
  };
  add(FamilyUse::truth, cells.truth);
  if (cells.nine_node > 0) add(FamilyUse::nine_node, cells.nine_node);
  for (const int judged : cells.judged) add(FamilyUse::bars, judged);
}

}  // namespace

std::vector<PlannedFamily> planned_families() {
  std::vector<PlannedFamily> families;
  const auto add = [&](int number, const CoveragePoint& point) {
    append(families, number, point, cells_of(number, point));
  };
  for (int number = 1; number <= points; ++number) add(number, point_of(number));
  for (int number = 1; number <= rubber_points; ++number)
    add(points + number, rubber_point_of(number));
  return families;
}

// Steps of an impact go with T/Δt: T ~ v^(-1/5), Δt with the smallest cell, which the contact
// radius ~ v^(2/5) sets, over the speed of pressure waves.
double relative_cost(const PlannedFamily& family) {
  const CoveragePoint& point = family.row.point;
  const double pressure_wave =
      std::sqrt((1.0 - point.poisson_ratio) /
                ((1.0 + point.poisson_ratio) * (1.0 - 2.0 * point.poisson_ratio)));
  const double runs = family.row.use == FamilyUse::nine_node ? 1e6
                      : family.row.use == FamilyUse::truth   ? 1.0 + 8.0 + 64.0
                                                             : 1.0 + 7.0 * 8.0 + 64.0;
  return runs * std::pow(family.row.cells, 1.5) * std::pow(point.speed, -0.6) * pressure_wave;
}

std::vector<PlannedFamily> families_to_try() {
  std::vector<PlannedFamily> families;
  append(families, 3, point_of(3), {.judged = {40, 60}, .truth = 80});
  return families;
}

}  // namespace rebound
