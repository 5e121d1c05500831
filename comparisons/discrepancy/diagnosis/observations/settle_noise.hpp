#pragma once

#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/observations/prepared_record.hpp"

/// Size, colour and zero of the noise of force records.
namespace rebound {

/// Colour of the noise of all records of a data set, and its size where it has a colour, or where
/// what they scatter by contradicts what is stated; the scatter of each shot alone where nothing is
/// stated. The size that belongs to a colour is the one that was found with it.
void settle_noise(const std::string& dataset, const std::vector<PreparedRecord>& records,
                  Observations& seen);

/// A recorder that rounds to one level again and again hides size and colour of all other noise.
/// Its errors are bounded by half a step and alike within one, so that no mean makes them less.
void settle_coarse_noise(const std::vector<PreparedRecord>& records, Observations& seen);

/// Mean of the force before contact, and how well it is known.
void settle_zero(const PreparedRecord& record, ForceNoise& noise);

}  // namespace rebound
