#pragma once

#include <functional>

#include "lumped/integration/composed/composed_contact.hpp"
#include "lumped/problem/trace.hpp"

namespace rebound {

/// A contact law, mechanisms included, whose ball moves as it is told.
///
/// Steps of fourth order (Runge–Kutta). What the contact remembers changes between steps.
///
/// Valid:   a plate at rest and a ball without an inner mass: what moves inside would have to be
///          driven by the whole force, the missing one included.
/// Limit:   driven by the velocities of an impact it gives the force of that impact
///          -> test DrivenContactTest.FollowsTheImpactItWasDrivenBy.
/// Error:   O(h²) in the deflection where the velocity is known at the ends of steps only.
class DrivenContact {
 public:
  /// Errors: as ComposedContact.
  explicit DrivenContact(const LumpedProblem& problem);

  /// Goes on for `step` seconds, the velocity changing evenly to `velocity`.
  void advance_to(double velocity, double step);
  /// Goes on for `step` seconds under the law's force and one more, f(x, v) [N].
  void advance_with(const std::function<double(double, double)>& added, double step);

  double deflection() const { return deflection_; }                      ///< of the ball [m]
  double velocity() const { return state_[ComposedContact::velocity]; }  ///< closing positive
  /// Of the law; zero once the law has let go [N].
  double force() const;
  double by_deflection() const;  ///< ∂F/∂x [N/m]
  double by_velocity() const;    ///< ∂F/∂v [N s/m]
  /// Has the contact ended, by the law?
  bool over() const { return over_; }
  const ContactScales& scales() const { return contact_.scales(); }

 private:
  using State = ComposedContact::State;
  template <class Field>
  void take_step(const Field& field, double step);
  void enter_next_phase(const State& before);
  double slope(std::size_t state, double difference) const;

  ComposedContact contact_;
  ContactPhase phase_;
  State state_;
  double deflection_ = 0.0;
  bool over_ = false;
};

/// Why a model cannot be driven; empty: it can.
std::string why_not_driven(const LumpedModel& model);

/// A force beside the law, and where it ends the contact.
struct ForceBeside {
  std::function<double(double x, double v)> force;  ///< [N]
  std::function<bool(double x, double v)> over;     ///< has contact ended, law and all
};

/// The impact of a ball under its law and one force more, or for ten times the scale of time.
Trace impact_with(const LumpedProblem& problem, const ForceBeside& beside);

}  // namespace rebound
