#pragma once

#include <string>

#include "comparisons/evaluation/atlas/atlas_maps.hpp"
#include "comparisons/io/report/report.hpp"
#include "comparisons/io/results/json.hpp"
#include "comparisons/io/toml/visitor.hpp"

namespace rebound {

/// What `rebound atlas FILE` reads: the grid, every axis optional.
void describe(Visitor& visit, AtlasGrid& grid);

/// Axes, laws, spreads over materials and the best law of every material.
Json to_json(const Atlas& atlas);
/// Every cell: one line a material, law, calibration speed and speed of use.
std::string to_csv(const Atlas& atlas);
/// The spreads as a table.
std::string to_text(const Atlas& atlas);
/// The maps as heat maps.
report::Report atlas_report(const Atlas& atlas);

}  // namespace rebound
