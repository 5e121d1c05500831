#pragma once

#include <vector>

#include "comparisons/discrepancy/diagnosis/asked_fem/fitted_fem.hpp"
#include "comparisons/discrepancy/diagnosis/believed_fem/fem_belief.hpp"
#include "comparisons/discrepancy/diagnosis/fits/hypothesis_fit.hpp"
#include "comparisons/discrepancy/diagnosis/fits/modelled_impact.hpp"
#include "comparisons/inference/calibration/observations.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound {

/// How far a search in FE goes: near the least, with differences to one side, or to the end, with
/// central ones from there.
enum class SearchDepth { near, whole };

inline constexpr double difference_step = 0.01;  // of a logarithm: above FE's step noise

/// The same ball with these effects. Factors of strain have a form only where every branch relaxes
/// all of the stress: beside them the ball is of that kind.
FittedFem with_effects(FittedFem ball, const std::vector<EffectChoice>& effects);

/// The shots run in FE, side by side.
/// Errors: those of FE.
std::vector<ModelledImpact> impacts_in_fem(const Observations& seen,
                                           const std::vector<std::size_t>& shots,
                                           const FemBelief& fem, const Material& material,
                                           const std::vector<EffectChoice>& effects);

/// FE's own idea of a ball that hides nothing but these effects.
///
///   unknown are the numbers of its material (MaterialUnknowns), those of the effects, and those of
///   the records (RecordsOfShots)
///
///   effects    where their numbers start; none: FE with nothing hidden. Faults of the measurement
///              among them act on the records
///   near       the kind of material and where it starts, of a fit without effects; null:
///              guess_fem_material()
///
/// Caution: the loss is what a fast branch gives, whatever the believed law says.
/// Limit:   data of FE itself, of another Poisson ratio and branch, are followed within their noise
///          -> test BesideFem.ImpactsOfFemLackNothing.
/// Errors:  those of calibrate() and FE; Error(solver_failed) without a shot.
FittedFem fit_fem_model(const Observations& seen, const std::vector<std::size_t>& shots,
                        const HypothesisFit& lumped, const FemBelief& fem,
                        const std::vector<EffectChoice>& effects, const FittedFem* near,
                        const RunControl& control, SearchDepth depth = SearchDepth::near);

/// What a fitted ball leaves of other shots: Σ r² over histories and priors, with start and speed
/// of every shot found anew and all else, the gain too, as it was fitted.
/// Errors: as above.
double chi_square_of(const Observations& shots_of, const std::vector<std::size_t>& shots,
                     const FemBelief& fem, const FittedFem& fitted, const RunControl& control);

}  // namespace rebound
