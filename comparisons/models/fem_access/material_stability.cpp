#include "comparisons/models/fem_access/material_stability.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <vector>

#include "comparisons/models/fem_access/material_laws.hpp"
#include "comparisons/models/fem_access/module_loader.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr double strain_step = 0.01;

using Corners = std::vector<std::array<double, 2>>;

/// Derivatives of the position by the two coordinates of a cell, at its centre.
Eigen::Matrix2d centre_map(const std::array<int, 4>& cell, const Corners& at) {
  const auto corner = [&](int i) {
    const auto& x = at[static_cast<std::size_t>(cell[static_cast<std::size_t>(i)])];
    return Eigen::Vector2d(x[0], x[1]);
  };
  Eigen::Matrix2d map;
  map.col(0) = 0.5 * (corner(1) + corner(2) - corner(0) - corner(3));
  map.col(1) = 0.5 * (corner(2) + corner(3) - corner(0) - corner(1));
  return map;
}

double mean_radius(const std::array<int, 4>& cell, const Corners& at) {
  return std::accumulate(cell.begin(), cell.end(), 0.0, [&](double sum, int vertex) {
    return sum + 0.25 * at[static_cast<std::size_t>(vertex)][0];
  });
}

/// Nominal stress at a stretch; empty where nothing frees the sides.
std::optional<double> nominal_stress(const Material& material, double stretch) {
  try {
    return material_laws().uniaxial(material, {stretch}).front().nominal_stress;
  } catch (const Error& error) {
    if (error.code() != ExitCode::solver_failed) throw;
    return std::nullopt;
  }
}

/// From 1 outwards to `end`, the first stretch at which the stress does not go on.
std::optional<double> first_unstable(const Material& material, double end) {
  const double step = end < 1.0 ? -strain_step : strain_step;
  const int steps = static_cast<int>((end - 1.0) / step);
  double before = 0.0;
  for (int i = 1; i <= steps; ++i) {
    const double stretch = 1.0 + i * step;
    const auto stress = nominal_stress(material, stretch);
    if (!stress || !((*stress - before) * step > 0.0)) return stretch;
    before = *stress;
  }
  return std::nullopt;
}

}  // namespace

StretchRange reached_stretches(const ShapeHistory& shapes) {
  StretchRange range;
  for (const Corners& now : shapes.positions)
    for (const auto& cell : shapes.cells) {
      const Corners& rest = shapes.positions.front();
      const Eigen::Matrix2d gradient = centre_map(cell, now) * centre_map(cell, rest).inverse();
      const Eigen::Vector2d in_section = gradient.jacobiSvd().singularValues();
      const double around = mean_radius(cell, now) / mean_radius(cell, rest);
      range.smallest = std::min({range.smallest, in_section[1], around});
      range.largest = std::max({range.largest, in_section[0], around});
    }
  return range;
}

std::optional<double> unstable_stretch(const Material& material, const StretchRange& range) {
  const auto pressed = first_unstable(material, range.smallest);
  const auto drawn = first_unstable(material, range.largest);
  if (pressed && drawn) return 1.0 - *pressed < *drawn - 1.0 ? pressed : drawn;
  return pressed ? pressed : drawn;
}

bool may_be_unstable(const Material& material) {
  return material.layers.empty() &&
         unstable_stretch(material, {.smallest = 0.3, .largest = 2.0}).has_value();
}

std::string instability_warning(const Material& material, const ShapeHistory& shapes) {
  if (shapes.positions.empty() || !material.layers.empty()) return {};
  const StretchRange range = reached_stretches(shapes);
  const auto unstable = unstable_stretch(material, range);
  if (!unstable) return {};
  return fmt::format(
      "the material is unstable beyond a strain of {:+.0f} % in slow uniaxial stress: its stress "
      "no longer rises there; this impact strains it from {:+.0f} to {:+.0f} %",
      100.0 * (*unstable - 1.0), 100.0 * (range.smallest - 1.0), 100.0 * (range.largest - 1.0));
}

FemResult watched_impact(const FemProblem& problem, const Mesh& mesh, const RunControl& control) {
  // Shapes take as long as the rest: they are kept only where a picture or the material asks.
  constexpr int watched_shapes = 24;
  if (!may_be_unstable(problem.material)) return fem_tier().simulate(problem, mesh, control);
  const bool pictured = problem.controls.shape_frames > 0;
  FemProblem watched = problem;
  if (!pictured) watched.controls.shape_frames = watched_shapes;
  FemResult result = fem_tier().simulate(watched, mesh, control);
  const std::string warning = instability_warning(problem.material, result.shapes);
  if (!pictured) result.shapes = {};
  if (warning.empty()) return result;
  if (result.incomplete_because.empty())
    result.warnings.push_back(warning);
  else
    result.incomplete_because += "; " + warning;
  return result;
}

}  // namespace rebound
