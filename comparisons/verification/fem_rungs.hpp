#pragma once

#include "comparisons/verification/verification_row.hpp"
#include "lumped/problem/modules.hpp"

namespace rebound {

/// Impacts of the FE tier with a known answer, and the invariants of every one:
///
///   d    sphere at 0.1, 0.5 and 1 m/s: Hertz with the finite-sphere correction
///   d'   bar without lateral contraction on a wall, under refinement
///   plate  two-body impact with a free plate: momentum, relative speed
///   convergence  15 m/s: observed orders of what converges monotonically
///
/// Some ten seconds. Errors: those of the tier; Error(solver_failed) where an
/// impact does not complete.
VerificationTable verify_fem(const FemTier& tier, const RunControl& control);

}  // namespace rebound
