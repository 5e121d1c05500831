#pragma once

#include "comparisons/io/toml/document.hpp"
#include "lumped/problem/impact.hpp"

namespace rebound {

/// Refuses a predicted deflection of 0.6 of the radius or more: no contact law
/// holds there, and a slip of a unit in speed or stiffness ends there.
/// Errors: Error(bad_input) at impact.speed.
void check_deflection(const Document& document, const Sphere& sphere, double peak_deflection);

}  // namespace rebound
