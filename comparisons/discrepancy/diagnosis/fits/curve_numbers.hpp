#pragma once

#include <cstddef>

#include "comparisons/discrepancy/diagnosis/fits/hypothesis_fit.hpp"
#include "comparisons/discrepancy/diagnosis/fits/smoothed_numbers.hpp"

namespace rebound {

/// What the numbers of effect `k` cost, its curves as smooth as a criterion wants them that takes
/// `each` of a number. Where the data leave a number of the fit undetermined all count as they
/// stand: k = Σ (1 − s²/σ²), s the error and σ that of the prior, one where there is none.
CostOfNumbers cost_of_numbers(const HypothesisFit& fit, std::size_t k, double each);

/// The same of all its numbers, whatever its curves are like and what the data hold at none.
double numbers_as_they_stand(const HypothesisFit& fit, std::size_t k);

}  // namespace rebound
