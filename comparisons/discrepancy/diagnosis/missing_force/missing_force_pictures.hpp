#pragma once

#include <vector>

#include "comparisons/discrepancy/diagnosis/missing_force/missing_force.hpp"
#include "comparisons/io/report/figure.hpp"

namespace rebound {

/// The missing force over deflection, loading and unloading apart, and over velocity: one line a
/// speed, with its band. Empty where it was not found.
std::vector<report::Figure> missing_force_figures(const MissingForce& missing);

}  // namespace rebound
