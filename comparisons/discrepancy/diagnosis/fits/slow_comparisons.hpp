#pragma once

#include <vector>

#include "comparisons/discrepancy/diagnosis/data_checks/data_checks.hpp"
#include "comparisons/discrepancy/diagnosis/fits/hypothesis_fit.hpp"

namespace rebound {

/// What was measured beside the impacts against a model that was fitted to them; compared only.
///
///   static-stiffness   measured slow force over the fit's static force, weighted mean [-]
///   block-modulus      (4/3) E/(1 − ν²) √R x^1.5 over the fit's static force at x = R/10, ν from
///                      0.2 to 0.5: the middle of the band, half of which counts as an error [-]
///   pooled-peak-force, pooled-peak-deflection   typical peaks over those of the fit [-]
///
/// A ball that is softer when it is slow has memory, or a stiffness that follows the rate: no fault
/// of the data. Two per cent of the fit's own stiffness count as an error. Pooled peaks without a
/// stated scatter are an order of magnitude: a half.
/// Valid:   block: small strain, exponent 3/2 near R/10.
/// Limit:   the law's own static force is one -> test SlowComparisonsTest.TheLawItselfIsOne.
/// Source:  Hertz 1882 for the block.
std::vector<DataCheck> compare_slow_tests(const Observations& seen, const HypothesisFit& fit);

}  // namespace rebound
