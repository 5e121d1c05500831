#pragma once

#include <vector>

namespace rebound {

/// Step of the recorder that a force was rounded to; 0 where none is seen [N].
///
/// The smallest distance of two readings, where all others are whole multiples of it and
/// neighbouring levels are used again and again: readings that are not rounded repeat nowhere.
///
/// Valid:   a record of more readings than levels; a thousandth of a step is forgiven.
/// Limit:   white noise without rounding has no step -> test QuantisationTest.NoiseHasNoStep.
double quantisation_step(const std::vector<double>& force);

/// Standard deviation of the error of rounding to steps.
///
///   σ = step/√12
///
/// Valid:   the reading moves over several steps, or noise does, so that errors of neighbours
///          are independent.
/// Source:  Widrow, Kollar & Liu, Statistical theory of quantization, IEEE Trans. Instrum.
///          Meas. 45 (1996).
double quantisation_noise(double step);

}  // namespace rebound
