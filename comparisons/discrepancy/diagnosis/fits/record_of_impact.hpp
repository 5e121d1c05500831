#pragma once

#include <vector>

#include "comparisons/discrepancy/diagnosis/fits/modelled_impact.hpp"
#include "comparisons/io/dataset/measured_impact.hpp"
#include "comparisons/models/instrument/measurement_chain.hpp"

/// A modelled impact of either tier beside the record of a shot.
namespace rebound {

/// The chain of a shot as its data set states it, with nothing wrong in it.
MeasurementChain stated_chain(const MeasuredImpact& shot);

/// What the load cell reads over a record: the contact, and the ringing of a plate that moves until
/// the last of `time` by the record's clock.
Trace contact_and_after(const ModelledImpact& impact, const MeasurementChain& chain,
                        const std::vector<double>& time);

/// Instant at which a force first rises above three tenths of its peak: above the noise, it finds
/// the start of a contact [s].
double rise_time(const Trace& trace);

}  // namespace rebound
