#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/effect_sensitivities.hpp"
#include "comparisons/discrepancy/diagnosis/excluded_sizes.hpp"
#include "comparisons/discrepancy/diagnosis/residual_map.hpp"

namespace rebound {

/// Numbers that decide; frozen, so that a verdict means the same everywhere.
struct SelectionRules {
  double false_gap_level = 0.02;  ///< chance that noise alone passes one of the two tests
  double close_criterion = 6.0;   ///< a rival within this information criterion is not ruled out
  double smallest_adequate_p = 1e-3;  ///< of χ²: below, a model does not explain the data
  int fitted_singles = 10;            ///< best scores that are fitted in full
  int fitted_pairs = 8;               ///< of sets of two effects and more, per step
  std::size_t most_effects = 4;       ///< of a set
};

/// A fitted set of effects, assessed.
struct AssessedFit {
  HypothesisFit fit;
  ResidualMap map;
  double p_value = 0.0;         ///< of χ² over the data
  double best_remaining = 0.0;  ///< largest Δχ² that one more effect would bring, to first order
  double remaining_threshold = 0.0;
  bool adequate = false;  ///< nothing left that noise could not do
};

/// Judges a fit: its residual map, χ², and what one more effect would bring.
AssessedFit judge(const Observations& seen, HypothesisFit fit,
                  const std::vector<std::string>& effects, const SelectionRules& rules,
                  std::uint64_t seed);

/// What is left of a search for effects.
struct EffectSelection {
  AssessedFit baseline;
  std::vector<EffectScore> scores;  ///< on the baseline's residuals
  EffectSensitivities::Cosines cosines;
  std::vector<ExcludedSize> excluded;          ///< where the baseline agrees with the data
  std::vector<AssessedFit> tried;              ///< all that were fitted, best criterion first
  std::vector<std::size_t> indistinguishable;  ///< indices into `tried`: not to be told apart

  /// Is there a model, with or without effects, that leaves nothing over?
  bool explains() const { return baseline.adequate || !indistinguishable.empty(); }
};

/// Looks for the smallest sets of effects that explain what the baseline does not.
///
///   1 first-order score of every effect on the baseline's residuals
///   2 the best single effects fitted in full, jointly over all shots
///   3 where none is adequate: the families, each by its free form
///   4 where none is adequate: sets of two, three and four, each from the best of one less;
///     what an adequate set of three or four does not need is taken out again
///   5 every adequate and minimal set within 6 of the best criterion is indistinguishable
///
/// An empty `indistinguishable` with an inadequate baseline means: not explained by
/// anything in the list.
EffectSelection select_effects(const Observations& seen, HypothesisFit baseline,
                               const std::vector<std::string>& effects, const SelectionRules& rules,
                               std::uint64_t seed, const RunControl& control = {});

}  // namespace rebound
