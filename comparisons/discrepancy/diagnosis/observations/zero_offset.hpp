#pragma once

#include <span>
#include <vector>

#include "comparisons/io/dataset/measured_impact.hpp"

namespace rebound {

/// The level on which the contact of a record stands [N]; 0: no level is seen.
///
/// The mean of the first twentieth of the record, where that and the last twentieth are flat and
/// alike, to five per cent of what the force rises by.
///
/// Valid:   a record with a twentieth of quiet on either side. A contact that is cut is steep where
///          it is cut: of a half sine a twentieth changes by nine per cent of the rise at least.
/// Limit:   a contact that is cut at both ends has no level
///          -> test ZeroOffsetTest.ACutContactHasNoLevel.
double level_of(const std::vector<double>& force);

/// Takes the level out of the shots of a data set, where it is beyond a twentieth of what the force
/// of any of them rises by: contacts are found by shares of the peak, over zero. A smaller one
/// stays, as a fault like any other that is fitted. The largest level; 0: all stay as they are.
double take_out_zero_offset(std::span<MeasuredImpact> shots);

}  // namespace rebound
