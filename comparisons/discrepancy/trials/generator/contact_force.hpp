#pragma once

#include <span>

#include "comparisons/discrepancy/trials/generator/impact_model.hpp"

namespace trials {

/// The contact force of one shot.
///
///   F = E + D + Σ share (E − u) − P
///
///   E  elastic force under its history   D  damping   u  branch state   P  pull
///
/// Without a pull F is cut off at zero: nothing holds the ball.
class ContactForce {
 public:
  /// Caution: keeps a reference to the model.
  ContactForce(const ImpactModel& model, const ShotOrder& shot);

  double force(const Approach& now, std::span<const double> branch_states) const;

  /// Time derivatives of the branch states.
  void branch_rates(const Approach& now, const double* states, double* rates) const;

  double touch_speed() const { return touch_speed_; }

 private:
  double virgin(double x) const;
  double elastic(const Approach& now) const;
  double driving(const MaxwellBranch& branch, const Approach& now, double elastic) const;

  const ImpactModel& model_;
  double touch_speed_;
  double stiffness_factor_ = 1.0;
};

}  // namespace trials
