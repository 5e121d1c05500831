#include "comparisons/discrepancy/trials/generator/contact_force.hpp"

#include <algorithm>

namespace trials {

ContactForce::ContactForce(const ImpactModel& model, const ShotOrder& shot)
    : model_(model), touch_speed_(shot.speed) {
  for (const auto& factor : model.stiffness_factors) stiffness_factor_ *= factor(shot);
}

double ContactForce::virgin(double x) const {
  if (x <= 0.0) return 0.0;
  const double hertz = hertz_force(model_.stiffness, x);
  return stiffness_factor_ * (model_.elastic ? model_.elastic(x, hertz) : hertz);
}

double ContactForce::elastic(const Approach& now) const {
  if (now.deflection <= 0.0) return 0.0;
  if (!model_.history) return virgin(now.deflection);
  return model_.history(now, [this](double x) { return virgin(x); });
}

double ContactForce::driving(const MaxwellBranch& branch, const Approach& now,
                             double elastic) const {
  if (branch.linear_stiffness > 0.0) return branch.linear_stiffness * std::max(0.0, now.deflection);
  return elastic;
}

double ContactForce::force(const Approach& now, std::span<const double> branch_states) const {
  const double x = now.deflection;
  const double from_spring = elastic(now);
  double force = from_spring;
  if (x > 0.0) {
    const double damped_part =
        model_.damping_follows_elastic ? virgin(x) : hertz_force(model_.stiffness, x);
    const double baseline = model_.damping * damped_part * now.rate;
    force += model_.dissipation ? model_.dissipation(now, baseline) : baseline;
    for (std::size_t i = 0; i < model_.branches.size(); ++i) {
      const MaxwellBranch& branch = model_.branches[i];
      force += branch.share * (driving(branch, now, from_spring) - branch_states[i]);
    }
  }
  if (!model_.pull) return std::max(0.0, force);
  // Before touch and beyond rupture nothing acts.
  if (now.largest <= 0.0 || x <= -model_.rupture_gap) return 0.0;
  return force - model_.pull(now);
}

void ContactForce::branch_rates(const Approach& now, const double* states, double* rates) const {
  if (model_.branches.empty()) return;
  const double from_spring = elastic(now);
  for (std::size_t i = 0; i < model_.branches.size(); ++i) {
    const MaxwellBranch& branch = model_.branches[i];
    rates[i] = (driving(branch, now, from_spring) - states[i]) / branch.time;
  }
}

}  // namespace trials
