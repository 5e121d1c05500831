#include "comparisons/evaluation/atlas/atlas_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "lumped/integration/closed_forms.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr Sphere ball{.mass = 0.0896, .diameter = 0.0662};
constexpr double storage_modulus = 10e6;  // E′ at ω [Pa]

double contact_time(double poisson_ratio, double speed) {
  const double stiffness = 4.0 / 3.0 * storage_modulus / (1.0 - poisson_ratio * poisson_ratio) *
                           std::sqrt(ball.radius());
  return elastic_impact({.stiffness = stiffness, .damping = 0.0},
                        {.mass = ball.mass, .speed = speed})
      .contact_time;
}

void check_axis(const std::vector<double>& axis, const char* key, double above, double below) {
  const bool good = !axis.empty() && std::all_of(axis.begin(), axis.end(),
                                                 [&](double v) { return v > above && v <= below; });
  if (!good || !std::is_sorted(axis.begin(), axis.end()))
    throw Error(ExitCode::bad_input, "an axis of the atlas is empty, out of range or not ascending",
                {.key = key,
                 .value = "",
                 .allowed = "ascending, above " + std::to_string(above) + ", at most " +
                            std::to_string(below)});
}

}  // namespace

double atlas_wave_speed() {
  return std::sqrt(storage_modulus / ball.density());
}

double reference_speed(const AtlasGrid& grid) {
  return grid.speeds[grid.speeds.size() / 2];
}

std::vector<AtlasMaterial> materials_of(const AtlasGrid& grid) {
  std::vector<AtlasMaterial> list;
  for (double nu : grid.poisson_ratios)
    for (double time : grid.relaxation_times)
      for (double loss : grid.loss_factors)
        if (std::numbers::pi * time * loss < 1.0)
          list.push_back({.loss_factor = loss, .poisson_ratio = nu, .relaxation_time = time});
  return list;
}

FemProblem atlas_problem(const AtlasGrid& grid, const AtlasMaterial& material, double speed) {
  const double time =
      contact_time(material.poisson_ratio, reference_speed(grid) * atlas_wave_speed());
  const double w = std::numbers::pi * material.relaxation_time, loss = material.loss_factor;
  const double ratio = loss * (1.0 + w * w) / (w * (1.0 - w * loss));
  FemProblem problem;
  problem.sphere = ball;
  problem.impact = {.speed = speed * atlas_wave_speed(), .separation = SeparationRule::zero_force};
  problem.cells = grid.cells;
  problem.material.youngs_modulus = storage_modulus / (1.0 + ratio * w * w / (1.0 + w * w));
  problem.material.poisson_ratio = material.poisson_ratio;
  problem.material.modulus = ModulusBasis::long_term;
  problem.material.branches = {{.ratio = ratio,
                                .relaxation_time = material.relaxation_time * time,
                                .relaxes = Relaxes::all}};
  return problem;
}

void check_grid(const AtlasGrid& grid) {
  check_axis(grid.speeds, "speeds", 0.0, 0.3);
  check_axis(grid.loss_factors, "loss_factors", 0.0, 2.0);
  check_axis(grid.poisson_ratios, "poisson_ratios", 0.0, 0.45);
  check_axis(grid.relaxation_times, "relaxation_times", 0.0, 100.0);
  if (grid.cells < 60 || grid.cells > 20000)
    throw Error(ExitCode::bad_input, "the mesh of the atlas is out of range",
                {.key = "cells", .value = std::to_string(grid.cells), .allowed = "60 to 20000"});
  const std::size_t impacts = materials_of(grid).size() * grid.speeds.size();
  if (impacts == 0 || impacts > 100000)
    throw Error(ExitCode::bad_input, "the atlas has no impacts or too many",
                {.key = "", .value = std::to_string(impacts), .allowed = "1 to 100000"});
}

}  // namespace rebound
