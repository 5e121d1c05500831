#pragma once

#include "comparisons/io/dataset/measured_impact.hpp"

namespace rebound {

/// Counts an error of the model among the errors of a history: the ripple of a contact front is
/// white, what a mesh gets wrong is shared by blocks, an eighth of the record long.
///
///   ρ_k → ρ_k σ²/(σ² + e²),  σ → √(σ² + e²)   of noise with a colour, e white beside it
///
/// Smooth noise has hardly any power at high frequencies, where an error of its colour would have
/// none either, and whitening would make a gap of the ripple.
/// Limit:  data with that error in them are white behind it, in size and colour
///         -> test NumericalErrorOfHistoryTest.IsWhiteBesideSlowNoise.
///
///   error   one standard deviation, e [N]
void add_numerical_error(MeasuredImpact& shot, double error);

}  // namespace rebound
