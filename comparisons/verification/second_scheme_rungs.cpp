#include "comparisons/verification/second_scheme_rungs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "comparisons/verification/targets.hpp"
#include "lumped/problem/error.hpp"
#include "meshes/generate/sphere_mesh.hpp"

namespace rebound {
namespace {

constexpr double radius = targets::ball_radius;
const Sphere ball{.mass = targets::ball_mass, .diameter = 2.0 * radius};
const Material rubber{.youngs_modulus = targets::ball_modulus,
                      .poisson_ratio = targets::ball_poisson_ratio};

class SecondSchemeRungs {
 public:
  SecondSchemeRungs(const FemTier& tier, const RunControl& control) : tier_(tier), control_(control) {}

  VerificationTable run() {
    for (const auto& target : targets::static_contacts) static_contact(target);
    slow_impact(targets::sphere_impacts[2]);
    for (const double ratio : {0.0, 0.4}) both_schemes(ratio);
    return std::move(table_);
  }

 private:
  void require(const std::string& incomplete, const std::string& name) const {
    if (incomplete.empty()) return;
    const bool stopped = control_.interrupted && control_.interrupted();
    throw Error(stopped ? ExitCode::interrupted : ExitCode::solver_failed, name + ": " + incomplete);
  }
  FemResult impact(const FemProblem& problem, const SphereMeshRequest& request) const {
    FemResult result =
        tier_.simulate(problem, generate_sphere_mesh(request), {.interrupted = control_.interrupted});
    require(result.incomplete_because, fmt::format("impact at {:g} m/s", problem.impact.speed));
    return result;
  }
  void static_contact(const targets::StaticContact& target);
  void slow_impact(const targets::SphereImpact& rung);
  void both_schemes(double ratio);

  const FemTier& tier_;
  const RunControl& control_;
  VerificationTable table_;
};

void SecondSchemeRungs::static_contact(const targets::StaticContact& target) {
  const bool half = target.platens == 2;
  const double a = target.a_over_r;
  const double approach = a * a * radius * (1.0 - target.s);
  const CompressionProblem problem{
      .sphere = ball,
      .compression = {.platens = target.platens, .deflection = approach * target.platens, .steps = 4},
      .material = rubber};
  const Mesh mesh = generate_sphere_mesh({.radius = radius, .cells = 400, .grading = 0.3 / (a * a),
                                          .part = half ? SpherePart::lower_half : SpherePart::whole});
  const CompressionResult result = tier_.compress(problem, mesh, {.interrupted = control_.interrupted});
  const std::string name = fmt::format("sphere {}, a/R {:g}", half ? "between platens" : "on a plate", a);
  require(result.incomplete_because, name);
  const double plane_strain =
      targets::ball_modulus / (1.0 - targets::ball_poisson_ratio * targets::ball_poisson_ratio);
  const double hertz =
      std::pow(0.75 * result.curve.force.back() / (plane_strain * std::sqrt(radius)), 2.0 / 3.0);
  table_.push_back({.rung = "c", .quantity = "approach over Hertz's, " + name, .unit = "",
                    .target = 1.0 - target.s, .result = approach / hertz,
                    .tolerance = target.tolerance, .scale = ToleranceScale::absolute,
                    .source = "linear elastic finite sphere, two independent computations"});
}

void SecondSchemeRungs::slow_impact(const targets::SphereImpact& rung) {
  FemProblem problem{.scheme = FemScheme::implicit_steps, .sphere = ball};
  problem.impact.speed = rung.speed;
  problem.material = rubber;
  const FemResult result = impact(problem, {.radius = radius, .cells = 250, .grading = targets::low_speed_grading});
  const char* source = "Hertz with finite-sphere correction, quasi-static and linear";
  const std::string name = fmt::format("sphere at {:g} m/s, implicit", rung.speed);
  table_.push_back({.rung = "d", .quantity = "largest force, " + name, .unit = "N",
                    .target = rung.force, .result = result.scalars.peak_force,
                    .tolerance = rung.force_tolerance, .source = source});
  table_.push_back({.rung = "d", .quantity = "contact time, " + name, .unit = "s",
                    .target = rung.time, .result = result.scalars.contact_time,
                    .tolerance = rung.time_tolerance, .source = source});
  table_.push_back({.rung = "invariant", .quantity = "impulse closure, " + name, .unit = "",
                    .target = 0.0, .result = result.closures.impulse, .tolerance = 1e-6,
                    .scale = ToleranceScale::absolute, .source = "momentum"});
  table_.push_back({.rung = "invariant", .quantity = "energy closure, " + name, .unit = "",
                    .target = 0.0, .result = result.closures.energy, .tolerance = 1e-3,
                    .scale = ToleranceScale::absolute, .source = "energy"});
}

void SecondSchemeRungs::both_schemes(double ratio) {
  FemProblem problem{.sphere = ball};
  problem.impact.speed = 15.0;
  problem.material = rubber;
  if (ratio > 0.0) problem.material.branches = {{ratio, 0.3e-3, Relaxes::all}};
  const FemResult first = impact(problem, {.radius = radius, .cells = 1000});
  problem.scheme = FemScheme::implicit_steps;
  const FemResult second = impact(problem, {.radius = radius, .cells = 250});
  const auto add = [&](const char* what, double target, double result, double tolerance) {
    table_.push_back({.rung = "schemes",
                      .quantity = fmt::format("{} at 15 m/s, {}, implicit against explicit", what,
                                              ratio > 0.0 ? "one branch" : "elastic"),
                      .unit = "", .target = 1.0, .result = result / target, .tolerance = tolerance,
                      .source = "two schemes that share no algorithm"});
  };
  add("restitution", first.restitution_momentum, second.restitution_momentum, 1e-3);
  add("largest deflection", first.scalars.peak_deflection, second.scalars.peak_deflection, 2e-3);
  add("largest force", first.scalars.peak_force, second.scalars.peak_force, 1e-2);
  add("contact time at 1 %", first.scalars.contact_time_1pct, second.scalars.contact_time_1pct, 1e-2);
}

}  // namespace

VerificationTable verify_second_scheme(const FemTier& tier, const RunControl& control) {
  return SecondSchemeRungs(tier, control).run();
}

}  // namespace rebound
