#pragma once

#include <vector>

#include "comparisons/discrepancy/diagnosis/asked_fem/fitted_fem.hpp"
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

/// Every ball fitted in FE (fit_fem_model), on meshes cut for a guess.
///
///   plates   where a plate on its load cell may be looked for. Where FE on a rigid one does not
///            follow the data, it is fitted with the ball from each of these, and stays where it
///            takes half of what FE left over without it.
///
/// Limit:  a ball of FE on a plate that moves comes out as such
///         -> test BesideFem.AStiffPlateUnderABallOfFemIsNamed.
/// Errors: as fit_fem_model().
std::vector<FittedFem> fit_own_balls(const Observations& all, const Observations& seen,
                                     const HypothesisFit& fit, const FemProblem& problem,
                                     const std::vector<EffectChoice>& plates,
                                     const RunControl& control);

}  // namespace rebound
