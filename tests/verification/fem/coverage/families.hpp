#pragma once

#include <vector>

#include "tests/verification/fem/coverage/plan.hpp"

namespace rebound {

/// Runs a family: a row for each quantity that is judged.
/// Errors: Error and std::runtime_error of an impact that does not run.
std::vector<CoverageRow> run_family(const PlannedFamily& family);

}  // namespace rebound
