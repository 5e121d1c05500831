#pragma once

#include <Eigen/Core>
#include <Eigen/QR>
#include <optional>

#include "comparisons/discrepancy/design/planned_data.hpp"

namespace rebound {

/// What a hidden effect leaves once the believed model is fitted to it.
///
///   ρ(θ) = r(θ) − r(θ₀) − Δ,   θ ← θ − J⁺ ρ(θ),   the change is −ρ at the end
///
///   Δ   what the effect moves of the residuals at the plan's own fit θ₀, exact in its size
///   J   ∂r/∂θ at θ₀; it stays, so that a step is one impact of each shot
///
/// A believed number that moves by a third takes up more of an effect than its derivative says.
/// Beside a believed FE model no steps are made: what derivatives take up is left to LinearRows.
/// The directions of effects move with the fit, too (PlannedPairs).
/// Limit:   a small effect leaves what first order says
///          -> test RefittedChangeTest.ASmallEffectLeavesWhatFirstOrderSays.
class RefittedChange {
 public:
  /// `data` must outlive this. May be asked by several threads.
  explicit RefittedChange(const PlannedData& data);

  /// What the effect leaves in the residuals [rows]; nothing where it has no form here, or no
  /// answer.
  std::optional<Eigen::VectorXd> by(const EffectChoice& effect) const;
  /// |change|², what derivatives can still take up taken out: how far χ² rises without noise.
  std::optional<double> rise(const EffectChoice& effect) const;

 private:
  std::optional<Eigen::VectorXd> unfitted(const EffectChoice& effect) const;

  const PlannedData& data_;
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> jacobian_;
};

}  // namespace rebound
