#include "comparisons/accuracy/verification/mesh_comparison.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "comparisons/accuracy/numerical_error/reference_impact.hpp"
#include "comparisons/accuracy/verification/known_impact.hpp"
#include "comparisons/accuracy/verification/mesh_family.hpp"
#include "comparisons/accuracy/verification/targets.hpp"
#include "lumped/problem/error.hpp"
#include "meshes/generate/sphere_mesh.hpp"
#include "meshes/quality/mesh_quality.hpp"

namespace rebound {
namespace {

Mesh make_mesh(MeshGenerator generator, const GmshModule& gmsh, int cells,
               const RunControl& control) {
  const SphereMeshRequest request{.radius = targets::ball_radius, .cells = cells};
  return generator == MeshGenerator::mapped ? generate_sphere_mesh(request)
                                            : gmsh.sphere(request, control);
}

MeshOutcome outcome_on(const FemTier& tier, const GmshModule& gmsh, MeshGenerator generator,
                       int cells, const RunControl& control) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  const Mesh mesh = make_mesh(generator, gmsh, cells, control);
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  FemProblem problem = ball_problem(FemScheme::explicit_steps, 15.0);
  problem.controls.output_interval = 1e-6;
  const MeshQuality quality = measure_quality(mesh);
  return {
      .generator = generator,
      .result = complete_impact(tier, problem, mesh, control,
                                fmt::format("{} {} cells", mesh.cells.size(), name_of(generator))),
      .smallest_edge = quality.smallest_edge,
      .worst_scaled_jacobian = quality.worst_scaled_jacobian,
      .mesh_seconds = seconds,
      .ripple = {}};
}

}  // namespace

const char* name_of(MeshGenerator generator) {
  return generator == MeshGenerator::mapped ? "mapped" : "unstructured";
}

std::vector<MeshOutcome> compare_meshes(const FemTier& tier, const GmshModule& gmsh, int cells,
                                        const RunControl& control) {
  constexpr int fewest = 80;
  if (cells < fewest)
    throw Error(ExitCode::bad_input, "a comparison needs more cells",
                {.key = "--cells", .value = std::to_string(cells), .allowed = ">= 80"});
  const std::vector<int> sizes = {cells / 4, cells, 4 * cells};
  std::vector<MeshOutcome> outcomes;
  for (const MeshGenerator generator : {MeshGenerator::mapped, MeshGenerator::unstructured}) {
    const std::size_t first = outcomes.size();
    for (const int size : sizes) {
      outcomes.push_back(outcome_on(tier, gmsh, generator, size, control));
      if (control.progress)
        control.progress(static_cast<double>(outcomes.size()) /
                         (2.0 * static_cast<double>(sizes.size())));
    }
    for (std::size_t i = first; i + 1 < outcomes.size(); ++i)
      outcomes[i].ripple = ripple_between(outcomes[i].result, outcomes[i + 1].result);
  }
  return outcomes;
}

Json to_json(const std::vector<MeshOutcome>& outcomes) {
  Json rows = Json::array();
  for (const MeshOutcome& one : outcomes)
    rows.push_back({{"generator", name_of(one.generator)},
                    {"cells", one.result.cells},
                    {"steps", one.result.steps},
                    {"ripple", number_or_null(one.ripple)},
                    {"peak_force_N", one.result.scalars.peak_force},
                    {"restitution", one.result.scalars.restitution},
                    {"smallest_edge_m", one.smallest_edge},
                    {"worst_scaled_jacobian", one.worst_scaled_jacobian},
                    {"mesh_s", one.mesh_seconds},
                    {"wall_s", one.result.wall_seconds}});
  return {{"schema", 1}, {"speed_m_s", 15.0}, {"meshes", rows}};
}

std::string to_text(const std::vector<MeshOutcome>& outcomes) {
  std::string text =
      "Elastic sphere at 15 m/s; ripple: largest deviation of the 20 us mean of the force from "
      "that "
      "on the\nnext mesh of the same kind, over 5 to 95 % of the contact, of its peak.\n\n";
  text += fmt::format("{:<13} {:>7} {:>7} {:>9} {:>12} {:>12} {:>9} {:>8} {:>8}\n", "mesh", "cells",
                      "steps", "ripple %", "peak force N", "restitution", "Jacobian", "mesh s",
                      "wall s");
  for (const MeshOutcome& one : outcomes)
    text += fmt::format("{:<13} {:>7} {:>7} {:>9} {:>12.1f} {:>12.6f} {:>9.3f} {:>8.3f} {:>8.3f}\n",
                        name_of(one.generator), one.result.cells, one.result.steps,
                        one.ripple ? fmt::format("{:.2f}", 100.0 * *one.ripple) : "-",
                        one.result.scalars.peak_force, one.result.scalars.restitution,
                        one.worst_scaled_jacobian, one.mesh_seconds, one.result.wall_seconds);
  return text;
}

VerificationPart verify_unstructured(const FemTier& tier, const GmshModule& gmsh,
                                     const RunControl& control) {
  constexpr int coarse = 250;
  const FemProblem problem = ball_problem(FemScheme::explicit_steps, 15.0);
  const RunControl quiet{.interrupted = control.interrupted, .progress = {}};
  const auto reference_on = [&](MeshGenerator generator) {
    return run_reference(tier, problem, make_mesh(generator, gmsh, coarse, quiet), quiet);
  };
  const ReferenceImpact mapped = reference_on(MeshGenerator::mapped);
  const ReferenceImpact free = reference_on(MeshGenerator::unstructured);
  VerificationPart part;
  for (std::size_t i = 0; i < mapped.errors.size(); ++i) {
    const std::string key = mapped.errors[i].key;
    if (key != "restitution" && key != "contact_time_1pct_s" && key != "peak_force_N" &&
        key != "peak_deflection_m")
      continue;
    const auto& scalar = scalars_with_error()[i];
    const double apart = std::abs(scalar.value(free.result) - scalar.value(mapped.result));
    part.rows.push_back(
        {.case_id = "meshes",
         .quantity = fmt::format("{}, {} unstructured against {} mapped cells, 15 m/s, difference "
                                 "over error bars",
                                 key, free.result.cells, mapped.result.cells),
         .unit = "",
         .target = 0.0,
         .result = apart / std::hypot(free.errors[i].uncertainty, mapped.errors[i].uncertainty),
         .tolerance = 1.0,
         .scale = ToleranceScale::absolute,
         .order = free.errors[i].meshes.observed_order,
         .source = "two families that share no algorithm"});
  }
  for (VerificationRow& row : invariants_of(
           free.result, fmt::format("sphere at 15 m/s, {} unstructured cells", free.result.cells)))
    part.rows.push_back(std::move(row));
  return part;
}

}  // namespace rebound
