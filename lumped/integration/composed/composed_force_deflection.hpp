#pragma once

#include <vector>

#include "lumped/integration/force_deflection.hpp"

namespace rebound {

/// forces_at() for a law with mechanisms: what the instrument reads where the
/// centre of mass has the given deflections.
std::vector<double> composed_forces_at(const LumpedProblem& problem,
                                       const DeflectionPoints& points);

}  // namespace rebound
