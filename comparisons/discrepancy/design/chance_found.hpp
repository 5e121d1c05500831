#pragma once

namespace rebound {

/// The chance that a gap is said of an effect, by one normal number.
///
///   P = max( p₀, Φ( √Δχ² − √T ) )
///
///   Δχ²  rise of χ² with the effect beside the fitted model
///   T    threshold of the largest gain
///   p₀   chance that noise alone passes it
///
/// Valid:   the gain is passed along the effect alone. A diagnosis asks more: PredictedDiagnosis.
/// Limit:   a rise of T is found in half of all tests
///          -> test ChanceFoundTest.TheThresholdIsFoundInHalfOfAllTests.
double chance_found(double rise, double threshold, double false_gap_level = 0.0);

/// The rise that is found with this chance, (√T + Φ⁻¹(P))².
double rise_of_chance(double chance, double threshold);

}  // namespace rebound
