#pragma once

#include "comparisons/evaluation/audit/audit.hpp"

namespace rebound {

/// The assumptions that FE shows by itself, from impacts with and without:
/// centre-of-mass, quasi-static, rigid-plate, friction. `base` are the impacts
/// at the request's speeds.
std::vector<AuditRow> audit_bodies(const AuditRequest& request, const std::vector<FemResult>& base,
                                   const FemRunner& run);

}  // namespace rebound
