#include "comparisons/accuracy/verification/lumped_cases.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "comparisons/accuracy/numerical_error/grid_convergence.hpp"
#include "comparisons/accuracy/verification/targets.hpp"
#include "lumped/integration/closed_forms.hpp"
#include "lumped/integration/simulate.hpp"

namespace rebound {
namespace {

constexpr double integrator_bound = 1e-9;

struct Integrator {
  const char* name;
  LumpedResult (*run)(const LumpedProblem&);
};
constexpr Integrator integrators[] = {{"CVODE", simulate}, {"fast", simulate_fast}};

LumpedProblem unit_problem(const char* law, double damping, SeparationRule rule) {
  LumpedProblem problem;
  problem.sphere = {.mass = 1.0, .diameter = 1.0};
  problem.impact = {.speed = 1.0, .separation = rule};
  problem.model.law = law;
  problem.model.parameters = {{"stiffness", 1.0}, {"damping", damping}};
  problem.controls = {.relative_tolerance = 1e-12, .samples = 401};
  return problem;
}

void add_hunt_crossley(VerificationTable& table) {
  for (const auto& [p, e] : targets::hunt_crossley)
    for (const Integrator& integrator : integrators) {
      const auto result =
          integrator.run(unit_problem("hunt-crossley", p, SeparationRule::zero_force));
      table.push_back({.case_id = "h",
                       .quantity = fmt::format("Hunt-Crossley restitution, damping number {:g}, {}",
                                               p, integrator.name),
                       .unit = "",
                       .target = e,
                       .result = result.scalars.restitution,
                       .tolerance = integrator_bound,
                       .scale = ToleranceScale::absolute,
                       .source = "exact relation of p and e"});
    }
}

void add_kelvin_voigt(VerificationTable& table) {
  for (const double zeta : {0.05, 0.2, 0.5})
    for (const auto rule : {SeparationRule::zero_force, SeparationRule::zero_deflection})
      for (const Integrator& integrator : integrators) {
        const auto result = integrator.run(unit_problem("linear-kelvin-voigt", 2.0 * zeta, rule));
        const bool force = rule == SeparationRule::zero_force;
        table.push_back(
            {.case_id = "h",
             .quantity = fmt::format("Kelvin-Voigt restitution, damping ratio {:g}, zero {}, {}",
                                     zeta, force ? "force" : "deflection", integrator.name),
             .unit = "",
             .target = kelvin_voigt_restitution(zeta, rule),
             .result = result.scalars.restitution,
             .tolerance = integrator_bound,
             .scale = ToleranceScale::absolute,
             .source = "closed form"});
      }
}

void add_kuwabara_kono(VerificationTable& table) {
  for (const auto& target : targets::kuwabara_kono)
    for (const Integrator& integrator : integrators)
      for (const auto rule : {SeparationRule::zero_deflection, SeparationRule::zero_force}) {
        const bool force = rule == SeparationRule::zero_force;
        const auto result = integrator.run(unit_problem("hertz-damped", target.beta, rule));
        table.push_back(
            {.case_id = "f",
             .quantity = fmt::format("Kuwabara-Kono restitution, beta {:g}, zero {}, {}",
                                     target.beta, force ? "force" : "deflection", integrator.name),
             .unit = "",
             .target = force ? target.restitution_f : target.restitution_x,
             .result = result.scalars.restitution,
             .tolerance = integrator_bound,
             .scale = ToleranceScale::absolute,
             .source = "Taylor integrator, 14 digits"});
      }
}

/// Aluminium sphere of 0.1 m on a rigid plate at 0.2 m/s: test 2 of Chung & Ooi.
void add_aluminium_sphere(VerificationTable& table) {
  constexpr double mass = 11.30554, radius = 0.1, modulus = 70e9, poisson = 0.3;
  LumpedProblem problem = unit_problem("hunt-crossley", 0.0, SeparationRule::zero_force);
  problem.sphere = {.mass = mass, .diameter = 2.0 * radius};
  problem.impact.speed = 0.2;
  problem.model.parameters["stiffness"] =
      4.0 / 3.0 * modulus / (1.0 - poisson * poisson) * std::sqrt(radius);
  problem.controls.samples = 4001;
  const ImpactScalars scalars = simulate_fast(problem).scalars;
  const auto add = [&](const char* quantity, const char* unit, double target, double result) {
    table.push_back(
        {.case_id = "published",
         .quantity = std::string("aluminium sphere at 0.2 m/s, ") + quantity,
         .unit = unit,
         .target = target,
         .result = result,
         .tolerance = 1e-6,
         .source = "Hertz; benchmark test 2 of Chung & Ooi, Granular Matter 13 (2011)"});
  };
  add("largest force", "N", 11369.858, scalars.peak_force);
  add("largest deflection", "m", 49.7172e-6, scalars.peak_deflection);
  add("contact time", "s", 731.6566e-6, scalars.contact_time);
}

}  // namespace

VerificationTable verify_lumped() {
  VerificationTable table;
  add_kuwabara_kono(table);
  add_hunt_crossley(table);
  add_kelvin_voigt(table);
  add_aluminium_sphere(table);
  return table;
}

VerificationTable verify_estimator() {
  const double fine = 0.97050;
  const GridError error = grid_convergence({.coarse = 0.96178, .medium = 0.96854, .fine = fine});
  const char* source = "Slater, NPARC Alliance verification tutorial, grid convergence";
  return {{.case_id = "published",
           .quantity = "grid-convergence index of the three-grid example",
           .unit = "",
           .target = 0.00103083,
           .result = error.uncertainty / fine,
           .tolerance = 1e-5,
           .order = error.observed_order,
           .source = source},
          {.case_id = "published",
           .quantity = "observed order of the three-grid example",
           .unit = "",
           .target = 1.786170,
           .result = error.observed_order.value_or(0.0),
           .tolerance = 1e-6,
           .order = error.observed_order,
           .source = source}};
}

}  // namespace rebound
