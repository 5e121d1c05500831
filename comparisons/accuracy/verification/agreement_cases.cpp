#include <fmt/format.h>

#include <cmath>

#include "comparisons/accuracy/numerical_error/reference_impact.hpp"
#include "comparisons/accuracy/verification/fem_cases.hpp"
#include "comparisons/accuracy/verification/known_impact.hpp"
#include "comparisons/accuracy/verification/targets.hpp"
#include "meshes/generate/sphere_mesh.hpp"

namespace rebound {
namespace {

FemResult in_scheme(const FemTier& tier, FemScheme scheme, double branch_ratio,
                    const RunControl& control) {
  FemProblem problem = ball_problem(scheme, 15.0);
  if (branch_ratio > 0.0) problem.material.branches = {{branch_ratio, 0.3e-3, Relaxes::all}};
  const int cells = scheme == FemScheme::implicit_steps ? 250 : 1000;
  return complete_impact(tier, problem,
                         generate_sphere_mesh({.radius = targets::ball_radius, .cells = cells}),
                         control, "impact at 15 m/s");
}

}  // namespace

VerificationPart verify_schemes(const FemTier& tier, const RunControl& control) {
  VerificationPart part;
  for (const double ratio : {0.0, 0.4}) {
    const FemResult first = in_scheme(tier, FemScheme::explicit_steps, ratio, control);
    const FemResult second = in_scheme(tier, FemScheme::implicit_steps, ratio, control);
    const char* material = ratio > 0.0 ? "one branch" : "elastic";
    const auto add = [&](const char* what, double target, double result, double tolerance) {
      part.rows.push_back(
          {.case_id = "schemes",
           .quantity = fmt::format("{} at 15 m/s, {}, implicit against explicit", what, material),
           .unit = "",
           .target = 1.0,
           .result = result / target,
           .tolerance = tolerance,
           .source = "two schemes that share no algorithm"});
    };
    add("restitution", first.restitution_momentum, second.restitution_momentum, 1e-3);
    add("largest deflection", first.scalars.peak_deflection, second.scalars.peak_deflection, 2e-3);
    add("largest force", first.scalars.peak_force, second.scalars.peak_force, 1e-2);
    add("contact time at 1 %", first.scalars.contact_time_1pct, second.scalars.contact_time_1pct,
        1e-2);
    append(part.rows,
           invariants_of(second, fmt::format("sphere at 15 m/s, {}, implicit", material)));
  }
  return part;
}

VerificationPart verify_free_plate(const FemTier& tier, const RunControl& control) {
  const double ball = targets::ball_mass, plate = 3.0 * ball;
  FemProblem problem = ball_problem(FemScheme::explicit_steps, 0.1);
  problem.plate = {.stiffness = 1e-3, .mass = plate, .damping_ratio = 0.0};
  const Mesh mesh = generate_sphere_mesh(
      {.radius = targets::ball_radius, .cells = 1000, .grading = targets::low_speed_grading});
  const std::string name = "sphere on a free plate of three balls' mass";
  const FemResult result = complete_impact(tier, problem, mesh, control, name);
  const double rebound = result.scalars.rebound_speed;
  const double plate_speed = std::sqrt(2.0 * result.energies.back().plate_kinetic / plate);
  VerificationPart part;
  part.rows = {{.case_id = "plate",
                .quantity = "momentum of the plate over that of the ball's change",
                .unit = "",
                .target = 1.0,
                .result = plate * plate_speed / (ball * (problem.impact.speed + rebound)),
                .tolerance = 1e-6,
                .source = "balance of momentum"},
               {.case_id = "plate",
                .quantity = "relative speed after over before, free plate",
                .unit = "",
                .target = 1.0,
                .result = (plate_speed + rebound) / problem.impact.speed,
                .tolerance = 2e-3,
                .source = "elastic two-body impact"}};
  append(part.rows, invariants_of(result, name));
  return part;
}

VerificationPart verify_all_channels(const FemTier& tier, const RunControl& control) {
  FemProblem problem = ball_problem(FemScheme::explicit_steps, 5.0);
  problem.gravity = 9.81;
  problem.material.branches = {{0.4, 0.3e-3, Relaxes::all}};
  problem.plate = {.stiffness = 2e6, .mass = 0.5, .damping_ratio = 0.1, .friction = 0.3};
  const Mesh mesh = generate_sphere_mesh({.radius = targets::ball_radius, .cells = 1000});
  const std::string name = "sphere at 5 m/s, branch, friction, gravity, plate on spring and damper";
  const FemResult result = complete_impact(tier, problem, mesh, control, name);
  VerificationPart part{.rows = invariants_of(result, name)};
  part.rows.push_back(constraint_row(result, name));
  return part;
}

VerificationPart verify_error_bars(const FemTier& tier, const RunControl& control) {
  const Mesh coarse = generate_sphere_mesh({.radius = targets::ball_radius, .cells = 500});
  const ReferenceImpact reference =
      run_reference(tier, ball_problem(FemScheme::explicit_steps, 15.0), coarse,
                    {.interrupted = control.interrupted, .progress = {}});
  VerificationPart part;
  for (std::size_t i = 0; i < reference.errors.size(); ++i) {
    const ScalarError& error = reference.errors[i];
    const std::string key = error.key;
    if (key != "restitution" && key != "peak_deflection_m" && key != "peak_force_N") continue;
    const double value = scalars_with_error()[i].value(reference.result);
    part.rows.push_back({.case_id = "convergence",
                         .quantity = "error bar over value, sphere at 15 m/s, " + key,
                         .unit = "",
                         .target = 0.0,
                         .result = error.uncertainty / value,
                         .tolerance = 5e-3,
                         .scale = ToleranceScale::absolute,
                         .order = error.meshes.observed_order,
                         .source = "what is called a reference is good to half a per cent"});
  }
  const std::string name = fmt::format("sphere at 15 m/s, {} cells", reference.result.cells);
  append(part.rows, invariants_of(reference.result, name));
  part.rows.push_back(constraint_row(reference.result, name));
  return part;
}

}  // namespace rebound
