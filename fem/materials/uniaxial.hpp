#pragma once

#include <vector>

#include "fem/interface/material_laws.hpp"

namespace rebound::fem {

/// A bar of the material under uniaxial stress, slowly: all branches relaxed, first
/// loading, no viscous stress.
///
///   S_lateral(λ, a) = 0 for the lateral stretch a;   P = λ S_axial
///
/// Limit:   hyperfoam with one β has a = λ^(−ν) -> test UniaxialTest.*
/// Errors:  Error(bad_input) for a material out of range or a stretch that is not
///          positive, Error(solver_failed) where no lateral stretch from 0.05 to 20
///          frees the sides.
std::vector<UniaxialState> uniaxial_states(const Material& material,
                                           const std::vector<double>& stretches);

}  // namespace rebound::fem
