#pragma once

#include "comparisons/discrepancy/diagnosis/search/score_test.hpp"

namespace rebound {

/// Is there a point of the loading from which on a fit leaves another share of the force than
/// before: something has slipped, cracked or come loose?
///
///   b(t) = F(t) from where the deflection is first c of its largest in that shot on, zero before;
///   c = 1/8 … 7/8, of all shots at one speed and above
///
/// Each is tested alone, as ScoredColumns; the largest counts, as so many times its chance as there
/// are of them. No effect of the list changes suddenly within a contact. A few numbers follow what
/// a change leaves over a whole loop, and thirty-four hats (test_further_force()) spread it thin.
///
/// Valid:   force histories of a lumped model, FE not in it.
/// Limit:   of noise a chance below 0.05 comes up in at most a twentieth of cases; a stiffness that
///          drops in the middle of a loading is seen where χ² is not
///          -> tests SuddenChangeTest.OfNoiseItIsRare, SuddenChangeTest.SeesAStiffnessThatDrops
/// Errors:  those of an impact that has no answer.
ScoreTest test_sudden_change(const Observations& seen, const HypothesisFit& fit,
                             const EffectSensitivities& around, double noise_freedom);

}  // namespace rebound
