#pragma once

#include "comparisons/evaluation/audit/audit.hpp"

namespace rebound {

/// The assumptions that a law makes, from fits to FE traces alone:
/// damping-power, one-stiffness, damping-formula, force-ends, mean-deflection, exponent.
std::vector<AuditRow> audit_laws(const std::vector<MeasuredImpact>& shots,
                                 const RunControl& control);

}  // namespace rebound
