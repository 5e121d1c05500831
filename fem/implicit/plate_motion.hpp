#pragma once

#include "fem/contact/free_plate.hpp"
#include "fem/implicit/equilibrium.hpp"
#include "fem/implicit/time_weights.hpp"
#include "lumped/problem/plate.hpp"

namespace rebound::fem {

/// A rigid plate on a spring and a damper, by the generalised-α method of the body.
///
///   M [(1 − α_m) a₁ + α_m a₀] + (1 − α_f) (c v₁ + k y₁ − F₁) + α_f (c v₀ + k y₀ − F₀) = 0
///
///   y displacement away from the ball [m];  F = Σ λ force of the ball [N]
///   c = 2 ζ √(k M)
///
/// Limit: a two-body impact on a free plate; the explicit scheme's plate
///        -> tests ImplicitContact
class PlateMotion {
 public:
  explicit PlateMotion(const Plate& plate);

  /// P and q of the step that begins now: what EquilibriumTask::plate takes.
  EquilibriumTask::PlateBalance balance(double step, const TimeWeights& weights) const;
  /// The step has ended at the displacement y under the force F.
  void accept(double step, const TimeWeights& weights, double displacement, double force);

  double displacement() const { return y_; }
  double reading() const { return stiffness_ * y_ + damping_ * v_; }  ///< of its load cell [N]
  double kinetic() const { return 0.5 * mass_ * v_ * v_; }            ///< [J]
  double spring() const { return 0.5 * stiffness_ * y_ * y_; }        ///< [J]
  double damper() const { return damper_; }                           ///< dissipated so far [J]
  FreePlate left_alone() const {
    return {.mass = mass_,
            .stiffness = stiffness_,
            .damping = damping_,
            .displacement = y_,
            .velocity = v_};
  }

 private:
  double mass_, stiffness_, damping_;
  double y_ = 0.0, v_ = 0.0, a_ = 0.0, force_ = 0.0, damper_ = 0.0;
};

}  // namespace rebound::fem
