#pragma once

#include <optional>
#include <vector>

#include "comparisons/discrepancy/diagnosis/asked_fem/fitted_fem_model.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/lumped_answer.hpp"
#include "comparisons/discrepancy/diagnosis/fits/held_out_gap.hpp"
#include "comparisons/discrepancy/diagnosis/fits/hypothesis_fit.hpp"
#include "comparisons/inference/calibration/observations.hpp"
#include "lumped/problem/run_control.hpp"

/// FE's own idea of every ball of some data.
namespace rebound {

/// Is what FE adds at one of these speeds what it adds at the other? It changes as slowly as the
/// speed over that of waves.
bool are_one_speed(double a, double b);

/// The speeds at which a ball was hit, repeats once.
std::vector<Impact> impacts_of(const Observations& all, std::size_t ball);

bool is_hit(const Observations& all, std::size_t ball);

/// Shots of a ball that FE is fitted to: of those that were seen one with a history at each speed.
std::vector<std::size_t> shots_for_fem(const Observations& seen, const Observations& all,
                                       std::size_t ball);

/// What is left of these shots together.
ShotGap together(const std::vector<ShotGap>& gaps, const std::vector<std::size_t>& shots);

/// Every ball fitted in FE as one of a single branch on a rigid plate, on meshes cut for a guess: a
/// first look that says where to cut.
/// Errors: as fit_fem_model().
std::vector<FittedFem> fit_rough_balls(const Observations& all, const Observations& seen,
                                       const HypothesisFit& fit, const FemProblem& problem,
                                       const RunControl& control);

/// Fits one ball in FE: what it is made of, and whether the plate under it moves.
class OwnBallFit {
 public:
  /// `shots`: that FE is fitted to. All that is given must outlive it.
  OwnBallFit(const Observations& seen, std::vector<std::size_t> shots, const LumpedAnswer& lumped,
             const FemBelief& fem, const RunControl& control);

  /// Is it of no use to look further? Effects beside the law explain the data, and FE's ball takes
  /// less of what they do than is worth a search (share_worth_a_search).
  /// Limit:  a ball that obeys a law with an effect stays one of a single branch, of a neo-Hookean
  ///         law
  ///         -> test OwnBallOfFem.IsSearchedNoFurtherWhereTheLawExplainsMore
  bool is_behind(const FittedFem& ball) const;

  /// Of that kind, with those effects, from those numbers; to the end on a rigid plate alone. On
  /// one that moves an impact takes longer, and a search has many starts.
  /// Errors: as fit_fem_model().
  FittedFem again(const FittedFem& near) const;

  /// Of the kinds of material near a fitted one of a single branch the one with the least
  /// information criterion; where it does not follow, the best of it and of what is found from
  /// branches three times as fast, and as slow.
  /// Limit:  a ball whose branch is of the deviator comes out as such
  ///         -> test OwnBallOfFem.MayHaveABranchOfTheDeviatorAlone
  /// Errors: as fit_fem_model().
  FittedFem of_best_kind(const FittedFem& plain) const;

  /// A ball on the plate that fits best, from each of these starts, where a plate takes half of
  /// what is left without it; else `rigid`, that of the best kind on a rigid plate. A plate that
  /// rings makes another kind of a ball of a single branch (`plain`), so that both are tried on it.
  /// Limit:  a ball of FE on a plate that moves comes out as such
  ///         -> test BesideFem.AStiffPlateUnderABallOfFemIsNamed.
  FittedFem on_best_plate(const FittedFem& plain, const FittedFem& rigid,
                          const std::vector<EffectChoice>& plates) const;

 private:
  FittedFem fitted_from(const FittedFem& near, SearchDepth depth) const;
  FittedFem of_other_times(FittedFem best) const;
  std::optional<FittedFem> fitted(const FittedFem& near, SearchDepth depth) const;

  const Observations& seen_;
  std::vector<std::size_t> shots_;
  const LumpedAnswer& lumped_;
  const FemBelief& fem_;
  const RunControl& control_;
};

}  // namespace rebound
