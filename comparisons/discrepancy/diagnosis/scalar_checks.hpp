#pragma once

#include <vector>

#include "comparisons/discrepancy/diagnosis/checked_shots.hpp"
#include "comparisons/discrepancy/diagnosis/data_checks.hpp"

namespace rebound {

/// Contact time, peak force and peak deflection as stated against what the record beside them
/// gives, whether they were read off it or measured by another instrument.
///
/// What was read off a record shares its scale; what was not has the uncertainties of gain or
/// deflection scale between the two. The highest of noisy samples lies above the peak: two
/// standard deviations of the noise count as an error.
std::vector<DataCheck> scalar_checks(const Observations& seen,
                                     const std::vector<CheckedShot>& shots);

}  // namespace rebound
