#pragma once

#include "comparisons/discrepancy/diagnosis/search/score_test.hpp"

namespace rebound {

/// Would a force over the deflection, the same at every speed or another one at each, follow what a
/// fit leaves over?
///
///   f = Σ a_j b_j(x),   b_j straight lines between points of the deflection x, loading and
///                       unloading apart
/// They are tested as ScoredColumns.
///
/// χ² of all readings hides what a few numbers tell: of two thousand readings its deviation is 63,
/// of these thirty 8. One force for all speeds has 34 points over the largest deflection of all,
/// one a speed has 14 over the largest of that speed. Of both tests the less likely outcome counts,
/// as twice its chance.
///
/// Valid:   force histories of a lumped model; without one nothing is tested. Nor is anything where
///          FE is in the model: what cells get wrong is a force over the deflection, too.
/// Limit:   of noise the chance is uniform; a force that no law has is seen where χ² is not
///          -> tests ForceScoreTest.OfNoiseItsChanceIsUniform,
///             ForceScoreTest.SeesWhatChiSquareDoesNot
/// Errors:  those of an impact that has no answer.
ScoreTest test_further_force(const Observations& seen, const HypothesisFit& fit,
                             const EffectSensitivities& around, double noise_freedom);

}  // namespace rebound
