#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/effect_sensitivities.hpp"
#include "comparisons/discrepancy/diagnosis/residual_map.hpp"

namespace rebound {

/// Numbers that decide; frozen, so that a verdict means the same everywhere.
struct SelectionRules {
  double false_gap_level = 0.02;  ///< chance that noise alone passes one of the two tests
  /// The same for a candidate: many are judged, and what is left over must not refuse the right
  /// one.
  double candidate_level = 0.002;
  double close_criterion = 6.0;  ///< a rival within this information criterion is not ruled out
  double smallest_adequate_p = 1e-3;  ///< of χ²: below, a model does not explain the data
  int fitted_singles = 10;            ///< best physical effects that are fitted in full
  int fitted_faults = 6;              ///< best faults of the measurement
  int fitted_pairs = 8;               ///< of sets of two effects and more, per step
  std::size_t most_effects = 3;       ///< of a set
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

/// Which fits get a residual map and a list of what one more effect would bring.
enum class Look { at_all, at_what_may_pass };

/// Those of `effects` that a fit does not have.
std::vector<std::string> absent_from(const HypothesisFit& fit,
                                     const std::vector<std::string>& effects);

/// Judges a fit: χ², its residual map, and what one more effect would bring by what is known
/// around it.
void judge_by(const EffectSensitivities& around, const Observations& seen,
              const SelectionRules& rules, std::uint64_t seed, Look look, AssessedFit& fit);

/// The same, with what is around it found first.
AssessedFit judge(const Observations& seen, HypothesisFit fit,
                  const std::vector<std::string>& effects, const SelectionRules& rules,
                  std::uint64_t seed, Look look = Look::at_all);

}  // namespace rebound
