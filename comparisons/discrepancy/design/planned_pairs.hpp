#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/discrepancy/design/planned_data.hpp"

namespace rebound {

/// How much of what first order says is seen of a hidden effect, measured.
///
///   κ = max |z̄_j| / |Δ|
///
///   z̄_j   what the residuals move by along a direction of the effect, j over its further numbers,
///   in
///         the mean of 32 pairs of experiments
///   Δ     what the effect leaves in the residuals to first order
///
/// Experiments as planned are made in pairs, with the effect and without, of the same noise. The
/// believed model is fitted to each, and z is taken along the directions where that fit has ended,
/// as a diagnosis takes it. Of an effect that the fit takes up nearly whole, directions turn with
/// the numbers of the fit, and those move with the noise; and what noise is estimated at is another
/// number for each experiment. A linear dashpot at two speeds is seen by 0.8.
///
/// Valid:   lumped believed models, of which an experiment takes some hundredths of a second.
/// Limit:   1 for an effect that the fit leaves alone
///          -> test PlannedPairsTest.FirstOrderHoldsForWhatTheFitLeavesAlone.
class PlannedPairs {
 public:
  /// `data`: the plan's own; must outlive this.
  PlannedPairs(const SynthesisFile& plan, const PlannedData& data);

  /// `change`: what the effect leaves in the residuals (RefittedChange). May be asked by several
  /// threads. Nothing where fewer than half of the experiments have an answer.
  std::optional<double> share_seen(const EffectChoice& effect, const Eigen::VectorXd& change) const;

 private:
  /// What the fit leaves along the directions of each effect, in their order.
  using AlongEffects = std::map<std::string, std::vector<double>>;
  std::optional<AlongEffects> experiment(std::size_t number,
                                         const std::vector<EffectChoice>& hidden,
                                         const std::vector<std::string>& effects) const;

  SynthesisFile plan_;
  const PlannedData& data_;
  std::vector<std::optional<AlongEffects>> without_;  ///< of experiments with nothing hidden
};

}  // namespace rebound
