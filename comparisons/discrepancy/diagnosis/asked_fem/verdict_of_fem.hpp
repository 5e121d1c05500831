#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "comparisons/discrepancy/diagnosis/asked_fem/fem_of_balls.hpp"
#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"

/// What is said where nothing lumped has a name, and FE was asked.
namespace rebound {

/// By criterion, of the unseen speed too: an effect that comes as near as another of another
/// family, and follows that speed worse, is no rival.
/// Limit:  with no unseen speed: the criterion of the fits
///         -> test VerdictOfFem.ARivalMustFollowTheUnseenSpeedAsWell
void sort_nearest_first(std::vector<EffectInFem>& in_fem);

/// What both tiers say of an effect. FE supports what pays, takes half of the gap, at the unseen
/// speed too where one is seen there, and leaves what its errors may.
EffectInFem with_verdicts(EffectInFem one, const FemOfAllBalls& without,
                          const SelectionRules& rules);

/// FE with nothing hidden leaves what noise and its own errors do: nothing is missing from the
/// physics.
bool is_the_noise(const FemOfAllBalls& without, const std::optional<double>& unseen);

/// The verdict is that model and data agree, with the gap that FE leaves.
/// Limit:  nothing stands of what a search beside a lumped law has found
///         -> test VerdictOfFem.NothingFoundStandsWhereFemFollows
void let_fem_stand(Diagnosis& d, const FemOfAllBalls& without, std::optional<double> unseen);

/// The family of `in_fem`, the nearest first: where all that FE supports within reach of the
/// nearest is of it; or where the nearest takes nine tenths of the gap and nothing of another
/// family half, so that what is left is more than noise, and little beside it. A fault of the
/// measurement is suspected as such.
///
/// Where effects of other families beside the law explain the data too, those of FE take their
/// place only if they are ahead by the criterion of both on the same errors; the law's stay where
/// they are ahead, and else it is one of both.
///
///   criterion_of_lumped   that of the law with its effects (FemOfBalls), asked for there only
///
/// Limit:  two families that explain the data leave the verdict as it is; so does one with a rival
///         that takes half -> test VerdictOfFem
void conclude_from_fem(Diagnosis& d, const SelectionRules& rules,
                       const std::function<double()>& criterion_of_lumped);

/// Where FE with nothing hidden follows the data, and follows them plainly better with each of
/// `in_fem`, the nearest first: the family of all that gain nearly as much as the nearest, or one
/// of them where families differ. What the unseen speed does not follow better, too, is not there.
/// Limit:  the verdict stays where the unseen speed denies the nearest
///         -> test VerdictOfFem.AWeakEffectMustHoldAtTheUnseenSpeed
void conclude_from_weak_effects(Diagnosis& d, const FemOfAllBalls& without);

/// Where the verdict is still that the data agree: unexplained, if FE with nothing hidden leaves
/// twice its noise on cells that are corrected for its own balls, at the unseen speed (`unseen`,
/// over its samples), too.
/// Limit:  a gap at the fitted speeds alone changes nothing
///         -> test VerdictOfFem.WhatIsLeftOnSharperCellsIsAGap
void deny_where_sharper_cells_do(Diagnosis& d, const FemOfAllBalls& without,
                                 std::optional<double> unseen);

}  // namespace rebound
