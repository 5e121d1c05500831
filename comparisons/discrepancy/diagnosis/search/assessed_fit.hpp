#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/search/effect_sensitivities.hpp"
#include "comparisons/discrepancy/diagnosis/search/force_score_test.hpp"
#include "comparisons/discrepancy/diagnosis/search/residual_map.hpp"
#include "comparisons/discrepancy/diagnosis/search/varying_numbers.hpp"

namespace rebound {

/// Numbers that decide; frozen, so that a verdict means the same everywhere.
struct SelectionRules {
  double false_gap_level = 0.02;  ///< chance that noise alone passes one of the two tests
  /// The same for a candidate: many are judged, and what is left over must not refuse the right
  /// one.
  double candidate_level = 0.002;
  double close_criterion = 6.0;  ///< a rival within this information criterion is not ruled out
  double smallest_adequate_p = 1e-3;  ///< of χ²: below, a model does not explain the data
  /// Of the believed model's test of a further force: below, something is missing.
  double least_likely_score = 3e-3;
  int fitted_singles = 10;       ///< best physical effects that are fitted in full
  int fitted_faults = 6;         ///< best faults of the measurement
  int fitted_pairs = 8;          ///< of sets of two effects and more, per step
  std::size_t most_effects = 4;  ///< of a set
  int bootstrap_draws = 999;     ///< repetitions of the choice; 0: none
  /// Of the repetitions: an effect that is chosen less often carries no name.
  double least_inclusion = 0.75;
};

/// A fitted set of effects, assessed.
struct AssessedFit {
  HypothesisFit fit;
  ResidualMap map;
  double p_value = 0.0;         ///< of χ² over the data
  double best_remaining = 0.0;  ///< largest Δχ² that one more effect would bring, to first order
  double remaining_threshold = 0.0;
  ScoreTest further_force;  ///< what a force without a formula would bring
  ScoreTest varying;        ///< what other numbers of the law from shot to shot would bring
  /// Of a believed model, where its search begins: what is known around it.
  std::shared_ptr<const EffectSensitivities> around;
  /// Of the speed that no fit saw; absent where it was not asked.
  std::optional<double> unseen_chi_square;
  bool unseen_denies = false;  ///< a rival predicts that speed plainly better
  bool judged = false;         ///< refused by its χ² alone, or looked at closely
  /// Not adequate by itself: noise could make its χ² and nearly its map, while some effect would
  /// still bring a little.
  bool nearly_adequate = false;
  bool adequate = false;  ///< nothing left that noise could not do

  /// χ² + k ln N, with the χ² of the unseen speed where that was asked.
  double information_criterion() const {
    return fit.information_criterion + unseen_chi_square.value_or(0.0);
  }
  /// χ² + 2 k, the same. By χ² + k ln N alone, an adequate model of one number would exclude a
  /// truth of two: ln N of all samples is more than the reach of a set.
  double prediction_criterion() const {
    return fit.prediction_criterion + unseen_chi_square.value_or(0.0);
  }
  /// Would a force without a formula bring what noise brings less often?
  bool leaves_a_force(double least_chance) const { return further_force.p_value <= least_chance; }
  /// Would the law's numbers vary from shot to shot by what they do less often?
  bool leaves_varying_numbers(double least_chance) const { return varying.p_value <= least_chance; }
  /// Where a curve is adequate: only since it is allowed to leave a share of the residuals.
  bool leaves_structure() const { return !map.quiet() || best_remaining > remaining_threshold; }
};

/// Is one of its effects a free form?
bool has_curve(const HypothesisFit& fit);

/// Is one of them loading and unloading, each by a curve of its own?
bool has_many_numbers(const HypothesisFit& fit);

/// Those of `effects` that are not present.
std::vector<std::string> absent_from(const std::vector<EffectChoice>& present,
                                     const std::vector<std::string>& effects);

/// What may be missing beside those that are present: everything in the list that has a name and a
/// form for a lumped model or a measurement.
std::vector<std::string> absent_effects(const std::vector<EffectChoice>& present);

/// A fit by its χ² alone: judged where that refuses it, and open otherwise.
AssessedFit judge_by_chi_square(const Observations& seen, HypothesisFit fit,
                                const SelectionRules& rules);

/// The freedom of noise that is known and not estimated.
constexpr double known_noise = std::numeric_limits<double>::infinity();

/// Looks at what is left over: the residual map, what one more effect would bring by what is
/// known around the fit, and what numbers would that the fit does not have. Where ν =
/// `noise_freedom` numbers told the noise, all limits are those of noise that is known with as
/// many.
void look_closely(const Observations& seen, const EffectSensitivities& around,
                  const SelectionRules& rules, double level, std::uint64_t seed,
                  double noise_freedom, AssessedFit& fit);

/// The same of a model that is believed, with the freedom of the noise before contact; a candidate
/// is judged as if the noise were known, for a search that goes on too long costs time and no name.
/// Effects that jump at first touch are fitted in full beside a lumped one: to first order they are
/// looked for where the law has the touch.
///
/// Limit:  a weak pull under noise with a colour is seen, and nothing more where nothing pulls
///         -> tests JumpAtTouchTest.AWeakPullIsSeenByAFit,
///            JumpAtTouchTest.WhereNothingPullsAFitFindsNoMore;
///         noise whose colour few samples tell is no gap
///         -> test NotFooledTest.CorrelatedNoiseIsNoGapWhereTheQuietIsShort.
void look_at_believed(const Observations& seen, const EffectSensitivities& around,
                      const SelectionRules& rules, std::uint64_t seed, AssessedFit& believed);

/// The model that is believed: looked at closely whatever its χ², for its map.
AssessedFit judge_believed(const Observations& seen, HypothesisFit fit,
                           const std::vector<std::string>& effects, const SelectionRules& rules,
                           std::uint64_t seed);

/// One of many candidates that χ² leaves open.
///
/// Of a free form a tenth of the baseline's residuals may be left, which is a hundredth of the χ²
/// that it explains: a smooth curve through six points is no closer to what it stands for. It never
/// carries a name. Where one more effect would bring up to a tenth of that χ², and nothing else is
/// left, it is nearly adequate; so is a formula, which then carries no name either.
///
/// What leaves more than half of the excess of a score test that showed the baseline's gap, as
/// noise does in less than a tenth, is neither. Limit:  -> test
/// ForceScoreTest.ACandidateThatLeavesWhatShowedTheGapIsNone.
void judge_candidate(const Observations& seen, const std::vector<std::string>& effects,
                     const SelectionRules& rules, std::uint64_t seed, const AssessedFit& baseline,
                     AssessedFit& candidate);

}  // namespace rebound
