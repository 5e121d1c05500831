#include "fem/schemes/impact_limits.hpp"

#include <cmath>

#include "fem/contact/adhesive_range.hpp"
#include "fem/materials/engineering_moduli.hpp"
#include "fem/materials/viscoelastic_constants.hpp"
#include "lumped/problem/error.hpp"
#include "lumped/problem/out_of_range.hpp"

namespace rebound::fem {
namespace {

constexpr double most_samples = 1e5;  ///< of a trace over one Hertz contact time

bool positive(double value) { return value > 0 && std::isfinite(value); }
bool zero_or_positive(double value) { return value == 0 || positive(value); }

void check_plate(const Plate& plate) {
  if (!zero_or_positive(plate.friction))
    refuse_out_of_range("model.plate.friction", plate.friction, ">= 0");
  if (!(plate.stiffness > 0))
    refuse_out_of_range("model.plate.stiffness", plate.stiffness, "> 0 N/m");
  if (!plate.moves()) return;
  if (!positive(plate.mass)) refuse_out_of_range("model.plate.mass", plate.mass, "> 0 kg");
  if (!zero_or_positive(plate.damping_ratio))
    refuse_out_of_range("model.plate.damping_ratio", plate.damping_ratio, ">= 0");
}

}  // namespace

double expected_contact_time(const FemProblem& problem, const Moduli& moduli) {
  const double plane_strain = plane_strain_modulus(moduli);
  const double m = problem.sphere.mass;
  return 2.8682657 * std::pow(m * m / (problem.sphere.radius() * plane_strain * plane_strain *
                                       problem.impact.speed),
                              0.2);
}

void check_problem(const FemProblem& problem) {
  const double safety = problem.controls.step_safety;
  const double interval = problem.controls.output_interval;
  const double end_time = problem.controls.end_time;
  if (!positive(problem.sphere.mass))
    refuse_out_of_range("sphere.mass", problem.sphere.mass, "> 0 kg");
  if (!positive(problem.sphere.diameter))
    refuse_out_of_range("sphere.diameter", problem.sphere.diameter, "> 0 m");
  if (!positive(problem.impact.speed))
    refuse_out_of_range("impact.speed", problem.impact.speed, "> 0 m/s");
  if (!(safety > 0 && safety <= 1)) refuse_out_of_range("controls.step_safety", safety, "(0, 1]");
  if (!zero_or_positive(end_time)) refuse_out_of_range("controls.end_time", end_time, ">= 0 s");
  if (!zero_or_positive(interval))
    refuse_out_of_range("controls.output_interval", interval, ">= 0 s");
  if (!zero_or_positive(problem.gravity))
    refuse_out_of_range("impact.gravity", problem.gravity, ">= 0 m/s^2");
  check_plate(problem.plate);
  const Moduli instantaneous = viscoelastic_constants(problem.material).instantaneous;
  check_adhesion(problem, instantaneous);
  const double contact = expected_contact_time(problem, instantaneous);
  if (interval > 0 && interval < contact / most_samples)
    refuse_out_of_range("controls.output_interval", interval,
                        "0, or a 100000th of the contact time and more");
  if (problem.impact.separation != SeparationRule::zero_force)
    throw Error(ExitCode::bad_input,
                "the FE tier separates by zero force alone: a deformable body need not be round "
                "again when its centre of mass is back",
                {.key = "impact.separation", .value = "zero-deflection", .allowed = "zero-force"});
}

}  // namespace rebound::fem
