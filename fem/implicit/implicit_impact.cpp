#include "fem/implicit/implicit_impact.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "fem/impact/adhesive_approach.hpp"
#include "fem/impact/energy_check.hpp"
#include "fem/impact/impact_conclusion.hpp"
#include "fem/impact/impact_recorder.hpp"
#include "fem/impact/residual_vibration.hpp"
#include "fem/impact/timed_impact.hpp"
#include "fem/implicit/adhesive_sides.hpp"
#include "fem/implicit/equilibrium.hpp"
#include "fem/implicit/implicit_fields.hpp"
#include "fem/implicit/separation_time.hpp"
#include "fem/implicit/time_weights.hpp"
#include "fem/interface/adhesive_range.hpp"
#include "fem/interface/check_problem.hpp"
#include "lumped/problem/error.hpp"

namespace rebound::fem {
namespace {

/// Everything that a step changes.
struct MotionState {
  Eigen::VectorXd u, v, a, force, reaction;
  double time = 0.0;
};

class ImplicitImpact {
 public:
  ImplicitImpact(const Mesh& mesh, const FemProblem& problem);
  FemResult run(const RunControl& control);

 private:
  void begin_approach();
  bool approach(double step, const RunControl& control);
  bool advance(double step, int cuts);
  Eigen::VectorXd first_guess(double step) const;
  EquilibriumTask task_of(double step) const;
  bool nearly_incompressible() const { return forces_.law().constants().mean_dilatation; }
  void accept(double step, MotionState next);
  void show_to_fields(double step, const MotionState& next);
  void sample();
  void fill(EnergyBalance& balance) const;
  bool contact_is_over() const;
  FemResult finish(std::string incomplete_because);
  void conclude(FemResult& result) const;

  const FemProblem& problem_;
  QuadraticBody body_;
  BodyForces forces_;
  const TimeWeights weights_ = time_weights(nearly_incompressible());
  AdhesiveTraction traction_;  ///< its range chosen
  std::optional<AdhesiveSides> adhesion_;
  EquilibriumSearch search_;
  ActiveSet held_;
  std::vector<int> massless_;  ///< unknowns without inertia
  MotionState now_;
  Eigen::VectorXd last_change_;
  double expected_time_, end_time_, interval_;
  int steps_per_sample_;
  ImpactRecorder recorder_;
  std::optional<ImplicitFields> fields_;  ///< where they are asked for
  bool approaching_ = false;              ///< pulled, and not touched yet: nothing is recorded
  double touch_speed_;                    ///< [m/s]
  EnergyBalance energies_;
  std::string failure_;
  int pole_ = 0;
  long steps_ = 0;
  double smallest_step_;
  double constraint_work_ = 0.0;
  SeparationTime separation_;  ///< of the plate's push, adhesion not in it
  double pull_ = 0.0;          ///< of adhesion [N]
  double contact_radius_ = 0.0, contact_radius_peak_ = 0.0;
  EnergyCheck balance_;
};

ImplicitImpact::ImplicitImpact(const Mesh& mesh, const FemProblem& problem)
    : problem_(problem),
      body_(quadratic_body(mesh, {.radius = problem.sphere.radius(), .mass = problem.sphere.mass})),
      forces_(body_, problem.material, ContactInertia::removed),
      traction_(chosen_adhesion(problem, forces_.law().constants().instantaneous)),
      search_(body_, forces_.mass()),
      held_(body_),
      expected_time_(expected_contact_time(problem, forces_.law().constants().instantaneous)),
      end_time_(problem.controls.end_time > 0 ? problem.controls.end_time : 20 * expected_time_),
      interval_(problem.controls.output_interval > 0 ? problem.controls.output_interval
                                                     : expected_time_ / 200),
      recorder_(interval_, expected_time_),
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
  for (const ContactPlace& place : body_.contact) massless_.push_back(2 * place.node + 1);
  for (const int unknown : massless_) now_.a[unknown] = 0.0;
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

/// Up to first touch, which is time zero: the last step ends there.
bool ImplicitImpact::approach(double step, const RunControl& control) {
  const auto speed = [&] { return -forces_.axial_mass().dot(now_.v) / body_.mass; };
  while (held_.gap(now_.u) > speed() * step)
    if ((control.interrupted && control.interrupted()) || !advance(step, 6)) return false;
  const double rest = held_.gap(now_.u) / speed();
  if (rest > 1e-3 * step && !advance(rest, 6)) return false;
  approaching_ = false;
  now_.time = 0.0;
  touch_speed_ = speed();
  return true;
}

/// Residual of one step as a function of the displacement at its end.
EquilibriumTask ImplicitImpact::task_of(double step) const {
  const double per_change = 1.0 / (weights_.beta * step * step);
  const Eigen::VectorXd carried = (1.0 - weights_.mass) * (per_change * (now_.u + step * now_.v) +
                                                           (0.5 / weights_.beta - 1.0) * now_.a) -
                                  weights_.mass * now_.a;
  const Eigen::VectorXd fixed_part =
      (weights_.force / (1.0 - weights_.force)) * (now_.force - now_.reaction) -
      forces_.mass().times(carried) / (1.0 - weights_.force);
  const double inertia = (1.0 - weights_.mass) * per_change / (1.0 - weights_.force);
  const double weight = problem_.gravity / (1.0 - weights_.force);
  EquilibriumTask task;
  task.linearise = [this, fixed_part = Eigen::VectorXd(fixed_part + weight * forces_.axial_mass()),
                    inertia](const Eigen::VectorXd& u, Eigen::VectorXd& residual,
                             SystemMatrix& matrix) {
    const auto outcome = forces_.linearise(u, inertia, residual, matrix);
    if (adhesion_) {
      adhesion_->add_forces(u, residual);
      adhesion_->add_derivative(u, matrix);
    }
    residual += fixed_part + inertia * forces_.mass().times(u);
    return outcome;
  };
  // The mean force of a contact, as a yardstick while there is none yet.
  task.force_scale =
      std::max(now_.force.norm(), 1e-2 * body_.mass * problem_.impact.speed / expected_time_);
  task.rounding = forces_.rounding();
  return task;
}

/// Where Newton's method begins. A body that hardly changes its volume begins where it is: any
/// motion ahead misses the volume by what its stiffness makes a pressure of.
Eigen::VectorXd ImplicitImpact::first_guess(double step) const {
  if (nearly_incompressible()) return now_.u;
  Eigen::VectorXd u = now_.u + step * now_.v + (0.5 * step * step) * now_.a;
  for (const int unknown : massless_) u[unknown] = now_.u[unknown] + last_change_[unknown];
  return u;
}

/// One step, in halves where it does not converge.
bool ImplicitImpact::advance(double step, int cuts) {
  forces_.law().set_step(step);
  const ActiveSet held_before = held_;
  MotionState next{.u = first_guess(step)};
  const auto found = search_.solve(task_of(step), next.u, held_, next.reaction);
  if (found.converged) {
    next.a = (next.u - now_.u - step * now_.v) / (weights_.beta * step * step) -
             (0.5 / weights_.beta - 1.0) * now_.a;
    next.v = now_.v + step * ((1.0 - weights_.gamma) * now_.a + weights_.gamma * next.a);
    for (const int unknown : massless_) {
      next.a[unknown] = 0.0;
      next.v[unknown] = (next.u[unknown] - now_.u[unknown]) / step;
    }
    next.time = now_.time + step;
    accept(step, std::move(next));
    return true;
  }
  held_ = held_before;
  failure_ = found.failure;
  if (cuts == 0) return false;
  return advance(0.5 * step, cuts - 1) && advance(0.5 * step, cuts - 1);
}

/// The end of a step, before the branches move there; the plate's push less its pull.
void ImplicitImpact::show_to_fields(double step, const MotionState& next) {
  fields_->see(next.u);
  Eigen::VectorXd push = next.reaction;
  if (adhesion_) {
    Eigen::VectorXd pull = Eigen::VectorXd::Zero(push.size());
    adhesion_->add_forces(next.u, pull);
    push -= pull;
  }
  fields_->press(push, {.step = step, .time = next.time});
}

void ImplicitImpact::accept(double step, MotionState next) {
  forces_.forces(next.u, next.force);
  if (adhesion_) adhesion_->add_forces(next.u, next.force);
  if (fields_ && !approaching_) show_to_fields(step, next);
  forces_.accept(next.u);
  const Eigen::VectorXd change = next.u - now_.u;
  constraint_work_ += 0.5 * change.dot(now_.reaction + next.reaction);
  const double force = next.reaction.sum();
  const double pull = adhesion_ ? adhesion_->pull(next.u) : 0.0;
  const double impulse = 0.5 * step * (separation_.last_force() + force - pull_ - pull);
  if (!approaching_) recorder_.add_impulse(impulse, now_.time, next.time);
  if (!approaching_) separation_.add(force, {.from = now_.time, .to = next.time});
  pull_ = pull;
  contact_radius_ = force > 0.0 ? held_.contact_radius(next.u) : 0.0;
  contact_radius_peak_ = std::max(contact_radius_peak_, contact_radius_);
  last_change_ = change;
  smallest_step_ = std::min(smallest_step_, step);
  now_ = std::move(next);
  ++steps_;
  if (fields_ && !approaching_) fields_->show(now_.time, now_.u, now_.v);
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
  balance.gravity = problem_.gravity * forces_.axial_mass().dot(now_.u);
}

void ImplicitImpact::sample() {
  fill(energies_);
  balance_.check(energies_);
  recorder_.add_sample({.deflection = -forces_.axial_mass().dot(now_.u) / body_.mass,
                        .pole_deflection = -now_.u[2 * pole_ + 1],
                        .contact_radius = contact_radius_,
                        .plate_displacement = 0.0},
                       energies_);
}

bool ImplicitImpact::contact_is_over() const {
  const double last = separation_.found();
  if (last == 0.0 || held_.any() || now_.time < 1.02 * last) return false;
  const double amplitude = residual_vibration_amplitude(
      energies_, forces_.law().constants(),
      {.mass = body_.mass, .density = body_.density, .radius = problem_.sphere.radius()});
  return forces_.axial_mass().dot(now_.v) > 0.0 &&
         held_.gap(now_.u) > amplitude + traction_.reach();
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

}  // namespace

FemResult run_implicit_impact(const Mesh& mesh, const FemProblem& problem,
                              const RunControl& control) {
  check(problem);
  check_implicit(problem);
  return timed_impact<ImplicitImpact>(control, mesh, problem);
}

}  // namespace rebound::fem
