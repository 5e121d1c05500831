#pragma once

namespace rebound {

/// The rise of χ² that passes a threshold with this chance.
///
///   Δχ² = ( √T + Φ⁻¹(P) )²,   0 where noise alone passes it more often
///
///   P   chance that the largest gain is above the threshold
///   T   the threshold
///
/// Valid:   the gain is passed along the effect alone. A diagnosis asks more: PredictedDiagnosis.
/// Limit:   T itself is passed in half of all tests
///          -> test RiseOfChanceTest.TheThresholdIsPassedInHalfOfAllTests.
double rise_of_chance(double chance, double threshold);

}  // namespace rebound
