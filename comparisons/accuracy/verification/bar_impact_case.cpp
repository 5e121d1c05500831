#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "comparisons/accuracy/verification/fem_cases.hpp"
#include "comparisons/accuracy/verification/known_impact.hpp"
#include "comparisons/accuracy/verification/refinement.hpp"
#include "comparisons/accuracy/verification/targets.hpp"
#include "meshes/generate/cylinder_mesh.hpp"

namespace rebound {
namespace {

constexpr double area = std::numbers::pi * targets::bar_radius * targets::bar_radius;

FemProblem bar_problem() {
  FemProblem problem;
  problem.sphere = {.mass = targets::bar_density * area * targets::bar_length,
                    .diameter = 2.0 * targets::bar_radius};
  problem.impact.speed = targets::bar_speed;
  problem.material = {.youngs_modulus = targets::bar_modulus, .poisson_ratio = 0.0};
  return problem;
}

/// Mean stress of the middle of the contact, where it is constant.
double middle_stress(const Trace& trace) {
  double force = 0.0, samples = 0.0;
  for (std::size_t i = 0; i < trace.time.size(); ++i)
    if (trace.time[i] > 0.2 * targets::bar_time && trace.time[i] < 0.8 * targets::bar_time) {
      force += trace.force[i];
      samples += 1.0;
    }
  return force / samples / area;
}

}  // namespace

VerificationPart verify_bar(const FemTier& tier, const RunControl& control) {
  std::array<FemResult, 3> family;
  Refinement work{.name = "the constraint work of the bar",
                  .size = {},
                  .error = {},
                  .expected_order = 1.0,
                  .tolerance = 0.1};
  for (int level = 0; level < 3; ++level) {
    const int along = 100 << level;
    const Mesh mesh = cylinder_mesh({.radius = targets::bar_radius,
                                     .length = targets::bar_length,
                                     .cells_across = 2,
                                     .cells_along = along});
    family[level] = complete_impact(tier, bar_problem(), mesh, control,
                                    fmt::format("bar of {} cells along", along));
    work.size.push_back(targets::bar_length / along);
    work.error.push_back(family[level].contact_constraint_share);
  }
  const FemResult& finest = family.back();
  const auto lost = [&](int level) { return 1.0 - family[level].restitution_momentum; };
  const char* source = "one-dimensional wave: stress rho c v, time 2 L/c, restitution 1";
  VerificationPart part;
  part.rows = {
      {.case_id = "d'",
       .quantity = "stress in the bar",
       .unit = "Pa",
       .target = targets::bar_stress,
       .result = middle_stress(finest.trace),
       .tolerance = 2e-3,
       .source = source},
      {.case_id = "d'",
       .quantity = "contact time of the bar",
       .unit = "s",
       .target = targets::bar_time,
       .result = finest.scalars.contact_time,
       .tolerance = 5e-3,
       .source = source},
      {.case_id = "d'",
       .quantity = "restitution of the bar",
       .unit = "",
       .target = 1.0,
       .result = finest.restitution_momentum,
       .tolerance = 5e-3,
       .order = std::log2(lost(1) / lost(2)),
       .source = source},
      order_row("d'", work, "plastic catch of one layer of nodes: first order in the cell")};
  for (VerificationRow& row : invariants_of(finest, "bar of 400 cells along"))
    part.rows.push_back(std::move(row));
  return part;
}

}  // namespace rebound
