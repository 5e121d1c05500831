#pragma once

#include <vector>

#include "comparisons/discrepancy/diagnosis/fits/hypothesis_fit.hpp"
#include "comparisons/inference/calibration/observations.hpp"
#include "comparisons/models/effects/effect.hpp"

/// Which effects a diagnosis tries in FE, and where their searches may start.
namespace rebound {

/// The starts of one effect after the other.
using StartsOfEffects = std::vector<std::vector<EffectChoice>>;

/// Of named effects that have a form in FE and are not in the lumped model yet: the usual size, and
/// ten and a hundred times that where it may be as large; a memory fades in half a contact. Those
/// that swing are found by their frequency (plates_of_lumped).
StartsOfEffects starts_of_named(const HypothesisFit& lumped);

/// Of curves over strain and over unloading, and of a spectrum of times: where no formula explains
/// the data, a family may.
StartsOfEffects starts_of_free_forms(const Observations& seen, const HypothesisFit& lumped);

/// Of faults of the measurement, over all that is tried of their numbers: they act on the record
/// of a ball, and no impact is run for them.
StartsOfEffects starts_of_faults(const Observations& seen, const HypothesisFit& lumped);

/// Of all these in turn.
StartsOfEffects all_starts(const Observations& seen, const HypothesisFit& lumped);

}  // namespace rebound
