#pragma once

#include "comparisons/discrepancy/diagnosis/search/score_test.hpp"

namespace rebound {

/// Would other numbers of the law, at each speed or in each shot, follow what a fit leaves over? A
/// model whose numbers have to be fitted again for every shot is no model of the ball.
///
///   columns   J_u w(shot),   u the numbers of the law that are fitted, of each ball
///   w         one at a speed, none at all others; or one in a shot
///
/// What begins at a critical speed is of this kind, and so is another ball in some of the shots. χ²
/// of all readings hides it: a stiffness that is 2 % more at one speed is one number of two
/// thousand. Of both tests the less likely outcome counts, as twice its chance.
///
/// Valid:   as test_further_force().
/// Limit:   of noise its chance is uniform; a stiffness that is another one at one speed is seen
///          where χ² is not -> tests VaryingNumbersTest.OfNoiseItsChanceIsUniform,
///                                   VaryingNumbersTest.SeesAStiffnessOfOneSpeed
/// Errors:  those of an impact that has no answer.
ScoreTest test_varying_numbers(const Observations& seen, const HypothesisFit& fit,
                               const EffectSensitivities& around, double noise_freedom);

}  // namespace rebound
