#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/search/assessed_fit.hpp"
#include "comparisons/discrepancy/diagnosis/search/excluded_sizes.hpp"

namespace rebound {

/// What is left of a search for effects.
struct EffectSelection {
  AssessedFit baseline;
  std::vector<EffectScore> scores;  ///< on the baseline's residuals
  /// Where the baseline agrees with what it was fitted to, and leaves a gap in all shots together:
  /// faults of one shot that would make it.
  std::vector<std::string> faults_of_one_shot{};
  EffectSensitivities::Cosines cosines;
  std::vector<ExcludedSize> excluded;          ///< where the baseline agrees with the data
  std::vector<AssessedFit> tried;              ///< all that were fitted, best criterion first
  std::vector<std::size_t> indistinguishable;  ///< indices into `tried`: not to be told apart

  /// Is there a model, with or without effects, that leaves nothing over?
  bool explains() const { return baseline.adequate || !indistinguishable.empty(); }
  /// The best candidate, or what the search started from.
  const HypothesisFit& best() const {
    return indistinguishable.empty() ? baseline.fit : tried[indistinguishable.front()].fit;
  }
};

/// What a search may ask of a speed that none of its fits sees; nothing where there is none.
struct UnseenSpeed {
  const Observations* shots = nullptr;      ///< those of that speed
  const Observations* with_seen = nullptr;  ///< and all others with them
};

/// Looks for the smallest sets of effects that explain what the baseline, judged by
/// judge_believed(), does not.
///
///   1 first-order score of every effect on the baseline's residuals
///   2 the best single effects, and every family by its free form, fitted jointly over all shots
///     of several balls the best of them again, with a size of every ball
///   3 where none is adequate, or another fits plainly better and leaves a little: sets of two to
///     four, each from the best of one less; what an adequate set does not need is taken out again
///   4 every adequate and minimal set within 6 of the best criterion is indistinguishable
///   5 of these the unseen speed takes out what predicts it worse (choose_with_unseen_speed)
///
/// A search begins where the baseline leaves a gap in what it was fitted to, or in all shots
/// together with those of the unseen speed.
///
/// A gap that noise makes once in fifty data sets, and that no effect explains by as much as one
/// candidate must be better than another, is noise: the baseline stands.
///
/// An empty `indistinguishable` with an inadequate baseline means: not explained by
/// anything in the list.
EffectSelection select_effects(const Observations& seen, AssessedFit baseline,
                               const std::vector<std::string>& effects, const SelectionRules& rules,
                               std::uint64_t seed, const RunControl& control = {},
                               const UnseenSpeed& unseen = {});

}  // namespace rebound
