#pragma once

#include <string>

#include "comparisons/io/report/report.hpp"
#include "fem/interface/fem_problem.hpp"
#include "fem/interface/fem_result.hpp"

namespace rebound {

/// One complete FE impact as a report: scalars, force over time and over deflection,
/// energies, closures, and the moving half-section where the result kept shapes.
/// Error bars of a reference run are drawn as a band.
/// Errors: Error(bad_input) for an incomplete result.
report::Report impact_report(const FemProblem& problem, const FemResult& result);

/// Frames of the half-section when `asked` are asked for on a mesh of `cells`: at
/// most 60, fewer than that above 2500 cells, none above 20000.
int animated_frames(int asked, int cells);

}  // namespace rebound
