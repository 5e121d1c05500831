#include "fem/implicit/implicit_impact.hpp"

#include <algorithm>
#include <cmath>

#include "fem/impact/adhesive_approach.hpp"
#include "fem/impact/impact_conclusion.hpp"
#include "fem/impact/residual_vibration.hpp"
#include "fem/impact/timed_impact.hpp"
#include "fem/implicit/implicit_steps.hpp"
#include "fem/interface/adhesive_range.hpp"
#include "fem/interface/check_problem.hpp"

namespace rebound::fem {
namespace {

/// Unknowns of contact nodes that have no inertia: in z, and in r where the plate rubs.
std::vector<int> massless_unknowns(const QuadraticBody& body, bool rubs) {
  std::vector<int> unknowns;
  for (const ContactPlace& place : body.contact) {
    if (rubs) unknowns.push_back(2 * place.node);
    unknowns.push_back(2 * place.node + 1);
  }
  return unknowns;
}

}  // namespace

ImplicitImpact::ImplicitImpact(const Mesh& mesh, const FemProblem& problem)
    : problem_(problem),
      body_(quadratic_body(mesh, {.radius = problem.sphere.radius(), .mass = problem.sphere.mass})),
      forces_(
          body_, problem.material,
          problem.plate.friction > 0.0 ? ContactInertia::removed_wholly : ContactInertia::removed),
      traction_(chosen_adhesion(problem, forces_.law().constants().instantaneous)),
      search_(body_, forces_.mass()),
      held_(body_, problem.plate.friction),
      method_(time_weights(nearly_incompressible()),
              massless_unknowns(body_, problem.plate.friction > 0.0)),
      expected_time_(expected_contact_time(problem, forces_.law().constants().instantaneous)),
      end_time_(problem.controls.end_time > 0 ? problem.controls.end_time : 20 * expected_time_),
      interval_(problem.controls.output_interval > 0 ? problem.controls.output_interval
                                                     : expected_time_ / 200),
      recorder_(interval_, expected_time_,
                problem.plate.moves() ? Reading::load_cell : Reading::contact_force),
      touch_speed_(problem.impact.speed),
      balance_(0.5 * problem.sphere.mass * problem.impact.speed * problem.impact.speed) {
  const double asked = problem.controls.step_safety / 0.9 * expected_time_ / 200;
  steps_per_sample_ = std::max(1, static_cast<int>(std::ceil(interval_ / asked - 1e-9)));
  smallest_step_ = interval_ / steps_per_sample_;
  if (FrameKeeper::is_requested(problem.controls))
    fields_.emplace(problem, body_, forces_, expected_time_);
  const int size = forces_.size();
  for (Eigen::VectorXd* field : {&now_.u, &now_.v, &now_.a, &now_.force, &now_.reaction})
    field->setZero(size);
  for (int node = 0; node < body_.node_count(); ++node) {
    now_.v[2 * node + 1] = -problem.impact.speed;
    now_.a[2 * node + 1] = -problem.gravity;
    if (body_.position[node][1] > body_.position[pole_][1]) pole_ = node;
  }
  for (const ContactPlace& place : body_.contact) now_.a[2 * place.node + 1] = 0.0;
  if (problem.plate.moves()) plate_.emplace(problem.plate);
  last_change_.setZero(size);
  if (traction_.acts()) {
    adhesion_.emplace(body_, traction_);
    begin_approach();
    adhesion_->add_forces(now_.u, now_.force);
    pull_ = adhesion_->pull(now_.u);
  }
}

/// At the edge of the adhesive range, in the time before zero.
void ImplicitImpact::begin_approach() {
  approaching_ = true;
  const auto lift = [&](double height) {
    for (int node = 0; node < body_.node_count(); ++node) now_.u[2 * node + 1] = height;
  };
  const AdhesiveApproach start = adhesive_approach(problem_, traction_.reach(), [&](double height) {
    lift(height);
    return adhesion_->energy(now_.u);
  });
  lift(start.height);
  for (int node = 0; node < body_.node_count(); ++node) now_.v[2 * node + 1] = -start.speed;
}

void ImplicitImpact::fill(EnergyBalance& balance) const {
  const double kinetic = 0.5 * now_.v.dot(forces_.mass().times(now_.v));
  const double speed = forces_.axial_mass().dot(now_.v) / body_.mass;
  balance.kinetic_centre_of_mass = 0.5 * body_.mass * speed * speed;
  balance.kinetic_vibration = kinetic - balance.kinetic_centre_of_mass;
  balance.stored = forces_.stored_energy(now_.u);
  balance.adhesion = adhesion_ ? adhesion_->energy(now_.u) : 0.0;
  const BodyForces::BranchEnergies branches = forces_.branch_energies(now_.u);
  balance.held = branches.held;
  balance.dissipated = branches.taken - branches.held;
  balance.contact_constraint = -constraint_work_;
  balance.friction = -friction_work_;
  if (plate_) {
    balance.plate_kinetic = plate_->kinetic();
    balance.plate_spring = plate_->spring();
    balance.plate_damper = plate_->damper();
  }
  balance.gravity = problem_.gravity * forces_.axial_mass().dot(now_.u);
}

void ImplicitImpact::sample() {
  fill(energies_);
  balance_.check(energies_);
  recorder_.add_sample({.deflection = -forces_.axial_mass().dot(now_.u) / body_.mass,
                        .pole_deflection = -now_.u[2 * pole_ + 1],
                        .contact_radius = contact_radius_,
                        .plate_displacement = held_.plate()},
                       energies_);
}

bool ImplicitImpact::contact_is_over() const {
  const double last = separation_.found();
  if (last == 0.0 || held_.any() || now_.time < 1.02 * last) return false;
  const double amplitude = residual_vibration_amplitude(
      energies_, forces_.law().constants(),
      {.mass = body_.mass, .density = body_.density, .radius = problem_.sphere.radius()});
  const double speed = forces_.axial_mass().dot(now_.v) / body_.mass;
  if (plate_)
    return is_out_of_reach(plate_->left_alone(), held_.gap(now_.u) - held_.plate(),
                           {.speed = speed, .vibration = amplitude, .horizon = end_time_});
  return speed > 0.0 && held_.gap(now_.u) > amplitude + traction_.reach();
}

FemResult ImplicitImpact::run(const RunControl& control) {
  std::string incomplete;
  const double step = interval_ / steps_per_sample_;
  if (approaching_ && !approach(step, control))
    return finish(failure_.empty() ? "interrupted" : failure_);
  sample();
  if (fields_) fields_->show(now_.time, now_.u, now_.v);
  while (incomplete.empty()) {
    for (int i = 0; i < steps_per_sample_ && incomplete.empty(); ++i) {
      if (control.interrupted && control.interrupted())
        incomplete = "interrupted";
      else if (!advance(step, 6))
        incomplete = failure_;
    }
    if (!incomplete.empty()) break;
    now_.time = recorder_.next_sample();
    sample();
    if (contact_is_over()) break;
    if (now_.time > end_time_) incomplete = "the contact had not ended by the end time";
    if (control.progress) control.progress(std::min(0.99, now_.time / (1.3 * expected_time_)));
  }
  return finish(std::move(incomplete));
}

FemResult ImplicitImpact::finish(std::string incomplete_because) {
  FemResult result;
  result.trace = recorder_.trace();
  result.energies = recorder_.energies();
  result.cells = static_cast<int>(body_.cells.size());
  result.vertices = body_.node_count();
  result.steps = steps_;
  result.smallest_step = smallest_step_;
  result.kernel = "implicit";
  if (fields_) result.shapes = fields_->shapes();
  result.incomplete_because = std::move(incomplete_because);
  if (result.incomplete_because.empty()) conclude(result);
  return result;
}

void ImplicitImpact::conclude(FemResult& result) const {
  conclude_impact(problem_, recorder_,
                  {.mass = body_.mass,
                   .touch_speed = touch_speed_,
                   .speed = forces_.axial_mass().dot(now_.v) / body_.mass,
                   .time = now_.time,
                   .last_contact = separation_.found(),
                   .initial_kinetic = balance_.brought(),
                   .energy_error = balance_.worst(),
                   .contact_radius_peak = contact_radius_peak_,
                   .energies = energies_},
                  result);
}

FemResult run_implicit_impact(const Mesh& mesh, const FemProblem& problem,
                              const RunControl& control) {
  check(problem);
  check_implicit(problem);
  return timed_impact<ImplicitImpact>(control, mesh, problem);
}

}  // namespace rebound::fem
