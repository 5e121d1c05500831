#pragma once

#include "fem/contact/plate_contact.hpp"
#include "lumped/problem/plate.hpp"

namespace rebound::fem {

/// Rigid plate that gives way: a mass on a spring and a damper,
/// as a plate on a load cell is. Acts on nodes as RigidPlate does, with a
/// velocity of its own.
///
///   M ÿ + c ẏ + k y = F,   c = 2 ζ √(k M),   load cell reads k y + c ẏ
///
///   y  displacement away from the ball [m]; its surface is at z = −y
///
/// One step, V the plate's velocity half a step before (−) and after (+) tₙ,
/// κ the kick, h the drift:
///
///   M (V₊ − V₋) = Σ I − I_a − κ [k (ȳ₋ + ȳ₊)/2 + c (V₋ + V₊)/2],  ȳ± = yₙ ± h± V±/2
///   I = m max(0, w − V₊),    w = −(z + yₙ)/h − v,    I_a the pull of adhesion
///
/// A node touches if w > V₊, and V₊ depends on which touch: one increasing
/// concave equation, which Newton's method solves in as many rounds as nodes
/// change sides, from the left and without overshoot. Body and plate
/// exchange momentum exactly -> test MovingPlateTest.ExchangesMomentum.
///
/// Valid:   any k, M > 0. Spring and damper are implicit (trapezoidal, exact in
///          energy at constant step), so a stiff cell does not shorten the step.
/// Limit:   k or M → ∞ is RigidPlate; k → 0 is a free body
///          -> tests MovingPlateImpact.
/// Caution: a plate whose own period is below some ten steps is resolved in the
///          mean only; its reading then alternates from step to step.
/// Source:  Hallquist et al. as RigidPlate; trapezoidal rule: Newmark 1959.
class MovingPlate final : public PlateContact {
 public:
  MovingPlate(const Discretisation& body, const Plate& plate,
              const AdhesiveTraction& adhesion = {});

  PlateStep apply_contact(const std::vector<double>& displacement, std::vector<double>& velocity,
                          const StepSpan& span) override;
  void drift(double span) override { displacement_ += span * velocity_; }
  PlateState state() const override;

  /// Clear when neither the plate's free motion nor the body's vibration can
  /// bring them together within the horizon. A plate that rings, or that
  /// returns later than that, leaves the answer as it is.
  bool is_clear_of(const std::vector<double>& displacement, const Departure& body) const override;

 private:
  /// `pull`: impulse of adhesion over the step [N s].
  double solve_velocity(const std::vector<double>& displacement, double pull,
                        const std::vector<double>& velocity, const StepSpan& span) const;

  double mass_, stiffness_, damping_;
  double displacement_ = 0.0;  ///< yₙ
  double velocity_ = 0.0;      ///< V₊, V₋ before apply_contact
  double velocity_before_step_ = 0.0;
  double middle_before_ = 0.0, middle_after_ = 0.0;  ///< ȳ₋, ȳ₊
  double damper_ = 0.0;       ///< dissipated up to half a step after tₙ [J]
  double damper_last_ = 0.0;  ///< of that, over the last kick
};

}  // namespace rebound::fem
