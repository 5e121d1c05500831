#include "fem/implicit/implicit_steps.hpp"

#include <algorithm>

namespace rebound::fem {

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
  const auto terms = method_.terms(step, now_, forces_, problem_.gravity);
  EquilibriumTask task;
  task.linearise = [this, terms](const Eigen::VectorXd& u, Eigen::VectorXd& residual,
                                 SystemMatrix& matrix) {
    const auto outcome = forces_.linearise(u, terms.inertia, residual, matrix);
    if (adhesion_) {
      adhesion_->add_forces(u, residual);
      adhesion_->add_derivative(u, matrix);
    }
    residual += terms.fixed + terms.inertia * forces_.mass().times(u);
    return outcome;
  };
  // The mean force of a contact, as a yardstick while there is none yet.
  task.force_scale =
      std::max(now_.force.norm(), 1e-2 * body_.mass * problem_.impact.speed / expected_time_);
  task.rounding = forces_.rounding();
  if (plate_) task.plate = plate_->balance(step, method_.weights());
  return task;
}

/// Where Newton's method begins. A body that hardly changes its volume begins where it is: any
/// motion ahead misses the volume by what its stiffness makes a pressure of.
Eigen::VectorXd ImplicitImpact::first_guess(double step) const {
  return nearly_incompressible() ? now_.u : method_.ahead(step, now_, last_change_);
}

/// One step, in halves where it does not converge.
bool ImplicitImpact::advance(double step, int cuts) {
  forces_.law().set_step(step);
  const ActiveSet held_before = held_;
  held_.begin_step(now_.u);
  MotionState next{.u = first_guess(step)};
  const auto found = search_.solve(task_of(step), next.u, held_, next.reaction);
  if (found.converged) {
    method_.complete(step, now_, next);
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

/// Of the plate on the body, split into what rubs and what holds; and what the plate gets of it.
void ImplicitImpact::add_plate_work(double step, const Eigen::VectorXd& change,
                                    const Eigen::VectorXd& reactions, double force) {
  for (const ContactPlace& place : body_.contact) {
    friction_work_ += 0.5 * change[2 * place.node] * reactions[2 * place.node];
    constraint_work_ += 0.5 * change[2 * place.node + 1] * reactions[2 * place.node + 1];
  }
  if (!plate_) return;
  const double before = plate_->displacement(), reading = plate_->reading();
  plate_->accept(step, method_.weights(), held_.plate(), force);
  constraint_work_ += 0.5 * (separation_.last_force() + force) * (plate_->displacement() - before);
  recorder_.add_reading(0.5 * step * (reading + plate_->reading()), now_.time, now_.time + step);
}

void ImplicitImpact::accept(double step, MotionState next) {
  forces_.forces(next.u, next.force);
  if (adhesion_) adhesion_->add_forces(next.u, next.force);
  if (fields_ && !approaching_) show_to_fields(step, next);
  forces_.accept(next.u);
  const Eigen::VectorXd change = next.u - now_.u;
  const double force = held_.push(next.reaction);
  add_plate_work(step, change, now_.reaction + next.reaction, force);
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

}  // namespace rebound::fem
