#include "fem/explicit/explicit_impact.hpp"

#include <algorithm>
#include <cmath>

#include "fem/explicit/explicit_steps.hpp"
#include "fem/impact/impact_conclusion.hpp"
#include "fem/impact/residual_vibration.hpp"
#include "fem/impact/timed_impact.hpp"
#include "fem/interface/check_problem.hpp"

namespace rebound::fem {

bool ExplicitImpact::contact_is_over() const {
  if (last_contact_ == 0.0 || time_ < 1.02 * last_contact_) return false;
  const double mass = motion_.total_mass();
  const double amplitude = residual_vibration_amplitude(
      energies_, material_,
      {.mass = mass, .density = body_.density, .radius = problem_.sphere.radius()});
  return plate_->is_clear_of(motion_.displacement, {.speed = motion_.momentum() / mass,
                                                    .vibration = amplitude + adhesion_.reach(),
                                                    .horizon = end_time_});
}

FemResult ExplicitImpact::run(const RunControl& control) {
  std::string incomplete;
  constexpr int look_around_every = 32;
  while (incomplete.empty()) {
    step();
    if (!(summary_.smallest_jacobian > 0.0))
      incomplete = "a cell was turned inside out (Jacobian <= 0)";
    else if (step_.collapsed())
      incomplete = "the stable step fell below 1e-4 of its first value";
    else if (time_ > end_time_)
      incomplete = "the contact had not ended by the end time";
    if (!incomplete.empty() || steps_ % look_around_every != 0) continue;
    // NaN is never below or above anything: no comparison above would see it.
    if (!motion_.is_finite()) incomplete = "the motion is no longer finite";
    if (!incomplete.empty()) break;
    if (contact_is_over()) break;
    if (control.interrupted && control.interrupted()) incomplete = "interrupted";
    if (control.progress) control.progress(std::min(0.99, time_ / (1.3 * expected_time_)));
  }
  return finish(std::move(incomplete));
}

FemResult ExplicitImpact::finish(std::string incomplete_because) {
  FemResult result;
  result.trace = recorder_.trace();
  result.energies = recorder_.energies();
  result.cells = arrays_.cells;
  result.vertices = body_.node_count();
  result.steps = steps_;
  result.smallest_step = step_.smallest();
  result.kernel = kernel_.name;
  result.incomplete_because = std::move(incomplete_because);
  if (fields_) result.shapes = fields_->shapes();
  if (result.incomplete_because.empty()) conclude(result);
  return result;
}

void ExplicitImpact::conclude(FemResult& result) const {
  const double mass = motion_.total_mass();
  conclude_impact(problem_, recorder_,
                  {.mass = mass,
                   .touch_speed = touch_speed_,
                   .speed = motion_.momentum() / mass,
                   .time = time_ - 0.5 * step_.before(),  // velocities belong to half steps
                   .last_contact = last_contact_,
                   .initial_kinetic = balance_.brought(),
                   .energy_error = balance_.worst(),
                   .contact_radius_peak = contact_radius_peak_,
                   .energies = energies_},
                  result);
}

FemResult run_explicit_impact(const Discretisation& body, const FemProblem& problem,
                              const RunControl& control) {
  check(problem);
  return timed_impact<ExplicitImpact>(control, body, problem);
}

}  // namespace rebound::fem
