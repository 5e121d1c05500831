#pragma once

#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/hypothesis_fit.hpp"

namespace rebound {

/// The effects that stand for a family of forms, where the model does not have them yet.
std::vector<std::string> free_forms(const std::vector<EffectChoice>& present);

/// Where a search for a free form starts: from nothing, with the ranges of its curves those that
/// the fitted model goes through in the data; for the memory family from several times.
std::vector<EffectChoice> starts_of_free_form(const EffectCard& card, const Observations& seen,
                                              const HypothesisFit& fit);

/// A factor found without a formula, over what it depends on.
struct FactorBand {
  std::string of;  ///< "deflection_over_radius", "rate_m_s", "share_of_largest_deflection", …
  std::vector<double> x, factor, low, high;  ///< with its 95 % interval
};

/// The curves of effect k of a fit; empty for an effect that is no free form.
std::vector<FactorBand> bands_of(const HypothesisFit& fit, std::size_t k);

}  // namespace rebound
