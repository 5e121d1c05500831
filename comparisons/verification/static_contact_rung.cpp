#include <fmt/format.h>

#include <cmath>

#include "comparisons/verification/fem_rungs.hpp"
#include "comparisons/verification/known_impact.hpp"
#include "comparisons/verification/targets.hpp"
#include "meshes/generate/sphere_mesh.hpp"

namespace rebound {
namespace {

VerificationRow static_contact(const FemTier& tier, const targets::StaticContact& target,
                               const RunControl& control) {
  constexpr double radius = targets::ball_radius;
  const bool half = target.platens == 2;
  const double a = target.a_over_r, approach = a * a * radius * (1.0 - target.s);
  const FemProblem ball = ball_problem(FemScheme::implicit_steps, 0.0);
  const CompressionProblem problem{
      .sphere = ball.sphere,
      .compression = {.platens = target.platens, .deflection = approach * target.platens, .steps = 4},
      .material = ball.material};
  const Mesh mesh = generate_sphere_mesh({.radius = radius, .cells = 400, .grading = 0.3 / (a * a),
                                          .part = half ? SpherePart::lower_half : SpherePart::whole});
  const CompressionResult result =
      tier.compress(problem, mesh, {.interrupted = control.interrupted, .progress = {}});
  const std::string name = fmt::format("sphere {}, a/R {:g}", half ? "between platens" : "on a plate", a);
  require_complete(result.incomplete_because, control, name);
  const double plane_strain =
      targets::ball_modulus / (1.0 - targets::ball_poisson_ratio * targets::ball_poisson_ratio);
  const double hertz =
      std::pow(0.75 * result.curve.force.back() / (plane_strain * std::sqrt(radius)), 2.0 / 3.0);
  return {.rung = "c", .quantity = "approach over Hertz's, " + name, .unit = "",
          .target = 1.0 - target.s, .result = approach / hertz, .tolerance = target.tolerance,
          .scale = ToleranceScale::absolute,
          .source = "linear elastic finite sphere, two independent computations"};
}

}  // namespace

VerificationPart verify_static_contact(const FemTier& tier, const RunControl& control) {
  VerificationPart part;
  for (const auto& target : targets::static_contacts)
    part.rows.push_back(static_contact(tier, target, control));
  return part;
}

}  // namespace rebound
