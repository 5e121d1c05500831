#pragma once

#include "comparisons/verification/verification_row.hpp"
#include "lumped/problem/modules.hpp"

namespace rebound {

/// What the nine-node cells answer: statics, and impacts by the implicit scheme.
///
///   c        sphere on a plate and between platens: finite-sphere correction of Hertz
///   d        sphere at 1 m/s, by the implicit scheme
///   schemes  15 m/s, elastic and with a branch: implicit against explicit
///
/// Some ten seconds. Errors: those of the tier; Error(solver_failed) where a run
/// does not complete.
VerificationTable verify_second_scheme(const FemTier& tier, const RunControl& control);

}  // namespace rebound
