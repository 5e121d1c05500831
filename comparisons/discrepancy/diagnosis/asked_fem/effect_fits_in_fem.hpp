#pragma once

#include <vector>

#include "comparisons/discrepancy/diagnosis/asked_fem/fem_of_balls.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/tried_in_fem.hpp"
#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"

namespace rebound {

/// Effects that are fitted in FE, one at a time, against FE with nothing hidden. Each stands in
/// `in_fem` of the diagnosis, the nearest first, with its verdict (with_verdicts).
///
/// Caution: looks at the diagnosis, at the balls and at the rules, which must outlive it.
class EffectFitsInFem {
 public:
  EffectFitsInFem(Diagnosis& d, const FemOfBalls& balls, FemOfAllBalls without,
                  const SelectionRules& rules, const RunControl& control);

  /// A plate that FE has found under its balls is an effect like any other. Faults of the
  /// measurement come next, which act on records alone, and physical effects beside them where FE
  /// is near enough for that. What an effect gains to first order says which are fitted first, and
  /// where FE nearly follows the data which are fitted at all. What rings at a frequency of its
  /// own, and leaves noise, has no rival among what does not ring, nor the other way about.
  void try_all(bool is_near);

  /// That which FE has found under its balls, where it has: does it explain the data?
  bool try_plate_of_fem();

  /// Does this explain them, beside the balls that FE has fitted without it?
  bool try_alone(const EffectChoice& effect);

  /// With nothing hidden, as near as any search has come.
  const FemOfAllBalls& without() const { return without_; }
  bool is_any_supported() const;

 private:
  /// Each of these by itself, from the nearest of its starts.
  void fit_each_of(const StartsOfEffects& starts);
  /// Where what comes nearest is a fault that swings, and takes a fair part of the gap. Is it a
  /// plate?
  bool try_plates_that_ring();
  void fit_promising_of(const StartsOfEffects& starts);
  void fit(const std::vector<EffectChoice>& starts);
  void add(const FemOfAllBalls& with);
  void compare_all_again();
  EffectInFem compared(const FemOfAllBalls& with) const;

  Diagnosis& d_;
  const FemOfBalls& balls_;
  FemOfAllBalls without_;
  std::vector<FemOfAllBalls> fits_;  ///< of effects
  const SelectionRules& rules_;
  const RunControl& control_;
};

}  // namespace rebound
