#pragma once

#include <string>

#include "lumped/problem/dimension.hpp"

namespace rebound {

/// SI unit of a dimension as a reader of contact laws writes it: "N/m^1.5",
/// "N.s/m^2.5", "m"; base units where no force is in it; empty for a number.
std::string unit_text(const Dimension& dimension);

}  // namespace rebound
