#pragma once

#include "comparisons/accuracy/numerical_error/reference_impact.hpp"
#include "comparisons/io/report/report.hpp"

namespace rebound {

/// What cells and step leave open in a run of a reference family: every scalar with its
/// error bar, where the bar comes from, and whether the four scalars that a reference
/// must know are known well enough.
report::Section error_bars(const ReferenceImpact& reference);

}  // namespace rebound
