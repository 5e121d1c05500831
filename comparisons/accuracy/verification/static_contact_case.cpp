#include <fmt/format.h>

#include <cmath>

#include "comparisons/accuracy/verification/element_cases.hpp"
#include "comparisons/accuracy/verification/fem_cases.hpp"
#include "comparisons/accuracy/verification/known_impact.hpp"
#include "comparisons/accuracy/verification/targets.hpp"
#include "meshes/generate/sphere_mesh.hpp"

namespace rebound {
namespace {

constexpr double radius = targets::ball_radius;
constexpr double plane_strain_modulus =
    targets::ball_modulus / (1.0 - targets::ball_poisson_ratio * targets::ball_poisson_ratio);

Mesh contact_mesh(int platens, double a_over_r, int cells) {
  return generate_sphere_mesh({.radius = radius,
                               .cells = cells,
                               .grading = 0.3 / (a_over_r * a_over_r),
                               .part = platens == 2 ? SpherePart::lower_half : SpherePart::whole});
}

std::string name_of(int platens, double a_over_r) {
  return fmt::format("sphere {}, a/R {:g}", platens == 2 ? "between platens" : "on a plate",
                     a_over_r);
}

double hertz_approach(double force) {
  return std::pow(0.75 * force / (plane_strain_modulus * std::sqrt(radius)), 2.0 / 3.0);
}

VerificationRow static_contact(const FemTier& tier, const targets::StaticContact& target,
                               const RunControl& control) {
  const double a = target.a_over_r, approach = a * a * radius * (1.0 - target.s);
  const FemProblem ball = ball_problem(FemScheme::implicit_steps, 0.0);
  const CompressionProblem problem{.sphere = ball.sphere,
                                   .compression = {.platens = target.platens,
                                                   .deflection = approach * target.platens,
                                                   .steps = 4},
                                   .material = ball.material};
  const Mesh mesh = contact_mesh(target.platens, a, 400);
  const CompressionResult result =
      tier.compress(problem, mesh, {.interrupted = control.interrupted, .progress = {}});
  const std::string name = name_of(target.platens, a);
  require_complete(result.incomplete_because, control, name);
  return {.case_id = "c",
          .quantity = "approach over Hertz's, " + name,
          .unit = "",
          .target = 1.0 - target.s,
          .result = approach / hertz_approach(result.curve.force.back()),
          .tolerance = target.tolerance,
          .scale = ToleranceScale::absolute,
          .source = "linear elastic finite sphere, two independent computations"};
}

/// C of x = x_Hertz − C F/(E R), linear kinematics.
VerificationRow linear_contact(const ElementChecks& checks,
                               const targets::LinearContactTarget& target) {
  const double approach = target.approach_over_hertz * target.hertz_over_r * radius;
  const double force = checks.linear_contact_force(
      contact_mesh(target.platens, target.a_over_r, 800),
      {.radius = radius,
       .material = ball_problem(FemScheme::implicit_steps, 0.0).material,
       .platens = target.platens,
       .approach = approach});
  return {.case_id = "c",
          .quantity = "C of linear kinematics, " + name_of(target.platens, target.a_over_r),
          .unit = "",
          .target = target.c,
          .result = (hertz_approach(force) - approach) * targets::ball_modulus * radius / force,
          .tolerance = 0.007,
          .scale = ToleranceScale::absolute,
          .source = "small-strain B-bar cells made apart, whose meshes scatter by 0.005"};
}

}  // namespace

VerificationPart verify_linear_contact(const ElementChecks& checks) {
  VerificationPart part;
  for (const auto& target : targets::linear_contacts)
    part.rows.push_back(linear_contact(checks, target));
  return part;
}

VerificationPart verify_static_contact(const FemTier& tier, const RunControl& control) {
  VerificationPart part;
  for (const auto& target : targets::static_contacts)
    part.rows.push_back(static_contact(tier, target, control));
  return part;
}

}  // namespace rebound
