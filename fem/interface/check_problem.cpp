#include "fem/interface/check_problem.hpp"

#include <cmath>

#include "fem/interface/adhesive_range.hpp"
#include "fem/interface/check_material.hpp"
#include "fem/interface/engineering_moduli.hpp"
#include "lumped/problem/error.hpp"
#include "lumped/problem/mechanisms.hpp"

namespace rebound {
namespace {

constexpr double most_samples = 1e5;        ///< of a trace over one Hertz contact time
constexpr double largest_deflection = 0.6;  ///< radii a plate: what the cells can follow

void check_output_interval(const FemProblem& problem, const fem::Moduli& instantaneous) {
  const double interval = problem.controls.output_interval;
  if (interval <= 0.0) return;
  if (interval < fem::expected_contact_time(problem, instantaneous) / most_samples)
    refuse_value("controls.output_interval", interval,
                 "0, or a 100000th of the contact time and more");
}

void check_path(const Compression& plan) {
  const bool slow = plan.path == CompressionPath::slow;
  if (slow && plan.duration != 0.0)
    throw Error(ExitCode::bad_input, "the slow path has no duration",
                {.key = "compression.duration", .value = number_text(plan.duration)});
  if (!slow && plan.duration == 0.0)
    throw Error(
        ExitCode::bad_input, "this path needs a duration",
        {.key = "compression.path", .value = name_of(plan.path), .allowed = "duration = \"4 ms\""});
}

}  // namespace

double fem::expected_contact_time(const FemProblem& problem, const Moduli& moduli) {
  const double plane_strain = plane_strain_modulus(moduli);
  const double m = problem.sphere.mass;
  return 2.8682657 *
         std::pow(
             m * m / (problem.sphere.radius() * plane_strain * plane_strain * problem.impact.speed),
             0.2);
}

double fem::expected_contact_radius(const FemProblem& problem, const Moduli& moduli) {
  const double radius = problem.sphere.radius(), v = problem.impact.speed;
  const double plane_strain = plane_strain_modulus(moduli);
  const double approach =
      std::pow(0.9375 * problem.sphere.mass * v * v / (plane_strain * std::sqrt(radius)), 0.4);
  return std::sqrt(radius * approach);
}

void check(const FemProblem& problem) {
  require_limits(problem.sphere, {"sphere"});
  require_limits(problem.impact, {"impact"});
  require_in_range(limit_of<&Mechanisms::gravity>.range, problem.gravity, {"impact"}, "gravity",
                   "m/s^2");
  require_limits(problem, {"model"});
  require_limits(problem.plate, {"model.plate"});
  require_limits(problem.adhesion, {"model.adhesion"});
  require_limits(problem.controls, {"controls"});
  check(problem.material);
  const fem::Moduli instantaneous = fem::instantaneous_moduli(problem.material);
  fem::check_adhesion(problem, instantaneous);
  check_output_interval(problem, instantaneous);
  if (problem.impact.separation != SeparationRule::zero_force)
    throw Error(ExitCode::bad_input,
                "the FE tier separates by zero force alone: a deformable body need not be round "
                "again when its centre of mass is back",
                {.key = "impact.separation",
                 .value = name_of(problem.impact.separation),
                 .allowed = name_of(SeparationRule::zero_force)});
  if (problem.scheme == FemScheme::implicit_steps) check_implicit(problem);
}

void check_implicit(const FemProblem& problem) {
  const auto refuse = [](const char* key, double value, const char* what) {
    throw Error(ExitCode::bad_input,
                std::string("the implicit scheme has no ") + what + "; take scheme = \"explicit\"",
                {.key = key, .value = number_text(value)});
  };
  if (problem.plate.moves() && problem.adhesion.acts())
    refuse("model.adhesion.work", problem.adhesion.work, "adhesion to a plate that moves");
  check_convolution_alone(problem.material, "model.scheme");
}

void check(const CompressionProblem& problem) {
  const Compression& plan = problem.compression;
  require_limits(problem.sphere, {"sphere"});
  require_limits(plan, {"compression"});
  require_limits(problem, {"model"});
  check(problem.material);
  const double largest = largest_deflection * problem.sphere.radius() * plan.platens;
  if (plan.deflection > largest)
    refuse_value("compression.deflection", plan.deflection,
                 "at most " + number_text(std::round(1e6 * largest) / 1e3) + " mm for " +
                     (plan.platens == 2 ? "two platens" : "one plate") + " of a ball of this size",
                 "beyond what the cells can follow");
  check_path(plan);
  check_convolution_alone(problem.material, "model.material");
}

}  // namespace rebound
