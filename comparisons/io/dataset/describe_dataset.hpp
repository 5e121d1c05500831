#pragma once

#include <string>
#include <vector>

#include "comparisons/io/dataset/dataset.hpp"
#include "comparisons/io/toml/visitor.hpp"

namespace rebound {

/// In SI, of any quantity: no instrument shows more, and sums of squares stay finite.
inline constexpr double largest_reading = 1e12;

void describe(Visitor& visit, Instrument& instrument);
void describe(Visitor& visit, MeasuredImpact& shot);
void describe(Visitor& visit, TraceChannels& channels);
void describe(Visitor& visit, AirStatement& air);
void describe(Visitor& visit, ShotTable& table);
void describe(Visitor& visit, Quasistatic& quasistatic);
void describe(Visitor& visit, BlockTest& block);
void describe(Visitor& visit, PooledPeak& peak);

/// A scalar `name` and its standard deviation `name_uncertainty`, both optional.
void describe_measured(Visitor& visit, const Key& key, Measured& measured);

/// Keys of a shot that a column of a table may hold.
std::vector<std::string> shot_column_keys();

/// A whole dataset.toml.
void describe(Visitor& visit, Dataset& dataset);

}  // namespace rebound
