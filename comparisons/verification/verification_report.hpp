#pragma once

#include "comparisons/report/report.hpp"
#include "comparisons/verification/mesh_family.hpp"
#include "comparisons/verification/verification_row.hpp"

namespace rebound {

/// The ladder as a page: every row with its verdict, and for a family of meshes
/// (none: left out) convergence, ripple and cost over the cells.
report::Report verification_report(const VerificationTable& table,
                                   const std::vector<FamilyImpact>& family);

}  // namespace rebound
