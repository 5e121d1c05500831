#pragma once

#include "comparisons/discrepancy/diagnosis/search/score_test.hpp"

namespace rebound {

/// Would a force over the deflection, of a few shapes that no law is asked for, follow what a fit
/// leaves over?
///
///   f = Σ a_j b_j(x),   b_j straight lines between points of the deflection x, loading and
///                       unloading apart; the same at every speed, or another one at each
///   f = x (a cos 2πnx/X + b sin 2πnx/X),   a ripple of n cycles over the largest deflection X of
///                       all, on one side of the loop
/// They are tested as ScoredColumns.
///
/// χ² of all readings hides what a few numbers tell: of two thousand readings its deviation is 63,
/// of these thirty 8. One force for all speeds has 34 points over the largest deflection of all,
/// one a speed has 14 over the largest of that speed. Ripples have 2 to 12 cycles in steps of a
/// half; of all these the least likely counts, as so many times its chance. Of the three tests
/// the least likely outcome counts, as three times its chance.
///
/// Valid:   force histories of a lumped model; without one nothing is tested. Nor is anything where
///          FE is in the model: what cells get wrong is a force over the deflection, too.
/// Limit:   of noise the chance is uniform, or less likely to be small; a force that no law has is
///          seen where χ² is not, and a ripple where straight lines are not
///          -> tests ForceScoreTest.OfNoiseItsChanceIsUniform,
///             ForceScoreTest.SeesWhatChiSquareDoesNot,
///             ForceScoreTest.SeesARippleThatStraightLinesDoNotFollow
/// Errors:  those of an impact that has no answer.
ScoreTest test_further_force(const Observations& seen, const HypothesisFit& fit,
                             const EffectSensitivities& around, double noise_freedom);

}  // namespace rebound
