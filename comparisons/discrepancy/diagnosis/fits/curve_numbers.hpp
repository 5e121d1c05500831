#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/fits/hypothesis_fit.hpp"
#include "comparisons/discrepancy/diagnosis/fits/smoothed_numbers.hpp"

namespace rebound {

/// The unknown of a fit that is this number of effect `k`, its size where `number` is empty;
/// nothing where it is not fitted.
std::optional<std::size_t> unknown_of(const HypothesisFit& fit, std::size_t k,
                                      const std::string& number);

/// The numbers of one effect of a fit, as a criterion counts them. A share that the data hold at
/// none, as of a spectrum that has no such time, is none.
struct NumbersOfEffect {
  /// k = Σ (1 − s²/σ²), s the error and σ that of the prior; one where there is none.
  double as_they_stand = 0.0;
  /// Where the effect has curves; nothing where the data leave a number undetermined.
  std::optional<FittedNumbers> of_curves;

  /// What they cost a criterion that takes `each` of a number: curves as smooth as it wants them.
  CostOfNumbers cost(double each) const {
    return of_curves ? smoothest(*of_curves, each) : CostOfNumbers{.numbers = as_they_stand};
  }
};

NumbersOfEffect numbers_of_effect(const HypothesisFit& fit, std::size_t k);

/// k of all its numbers, whatever its curves are like and what the data hold at none.
double all_numbers_of_effect(const HypothesisFit& fit, std::size_t k);

}  // namespace rebound
