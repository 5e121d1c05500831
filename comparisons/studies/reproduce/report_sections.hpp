#pragma once

#include <vector>

#include "comparisons/io/report/report.hpp"
#include "comparisons/studies/reproduce/reproduction.hpp"

namespace rebound {

/// What a report says of the paper's numbers, ready to be put among its other
/// sections: "What the paper's numbers do not imply" (findings, then the rows
/// that differ), the other rows folded, and Figures 3 to 6.
///
/// The figures are predicted from published parameters: the paper prints no
/// trace, so every line is a model's and only tabled scalars are points.
std::vector<report::Section> report_sections(const Reproduction& reproduction);

/// The same as a report of its own.
report::Report reproduction_report(const Reproduction& reproduction);

}  // namespace rebound
