#pragma once

#include "comparisons/io/dataset/dataset.hpp"
#include "comparisons/io/toml/visitor.hpp"

namespace rebound {

void describe(Visitor& visit, Instrument& instrument);
void describe(Visitor& visit, MeasuredImpact& shot);
void describe(Visitor& visit, Quasistatic& quasistatic);
void describe(Visitor& visit, BlockTest& block);
void describe(Visitor& visit, PooledPeak& peak);

/// A whole dataset.toml.
void describe(Visitor& visit, Dataset& dataset);

}  // namespace rebound
