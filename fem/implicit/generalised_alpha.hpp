#pragma once

#include <Eigen/Core>
#include <vector>

#include "fem/implicit/body_forces.hpp"
#include "fem/implicit/time_weights.hpp"

namespace rebound::fem {

/// Everything that a step changes in a body.
struct MotionState {
  Eigen::VectorXd u, v, a, force, reaction;
  double time = 0.0;
};

/// The generalised-α method for a body whose contact nodes have no inertia of their own.
///
///   M [(1 − α_m) a₁ + α_m a₀] + (1 − α_f) (f₁ − λ₁) + α_f (f₀ − λ₀) + M g = 0
///   u₁ = u₀ + Δt v₀ + Δt² [(½ − β) a₀ + β a₁],   v₁ = v₀ + Δt [(1 − γ) a₀ + γ a₁]
///
/// `massless` unknowns move as they are moved: a = 0, v = Δu/Δt.
/// Limit: second order in the step -> test VerificationCaseA.BothSchemesAreOfSecondOrderInTime
class GeneralisedAlpha {
 public:
  GeneralisedAlpha(const TimeWeights& weights, std::vector<int> massless)
      : weights_(weights), massless_(std::move(massless)) {}

  const TimeWeights& weights() const { return weights_; }

  /// The step's equation over (1 − α_f), f₁ and λ₁ apart: inertia · M u₁ + fixed.
  struct StepTerms {
    Eigen::VectorXd fixed;
    double inertia = 0.0;  ///< [1/s²]
  };
  StepTerms terms(double step, const MotionState& now, const BodyForces& forces,
                  double gravity) const;

  /// Where the body would be without a change of its acceleration.
  Eigen::VectorXd ahead(double step, const MotionState& now,
                        const Eigen::VectorXd& last_change) const;

  /// Velocity and acceleration at the end of the step, from the displacement there.
  void complete(double step, const MotionState& now, MotionState& next) const;

 private:
  TimeWeights weights_;
  std::vector<int> massless_;
};

}  // namespace rebound::fem
