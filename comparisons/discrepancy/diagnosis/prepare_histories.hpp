#pragma once

#include <cstddef>

#include "comparisons/inference/calibration/observations.hpp"
#include "comparisons/io/dataset/dataset.hpp"

namespace rebound {

/// Prepares the histories of one data set, from the shots `first` on: those that are no whole
/// impact go; noise, its colour and its rounding are settled from the whole records, which are then
/// cut to the contact with some of the quiet around it. observe() says the rules. A shot whose
/// noise nothing tells loses its history, and says so among what is missing.
void prepare_histories(const Dataset& dataset, std::size_t first, Observations& seen);

}  // namespace rebound
