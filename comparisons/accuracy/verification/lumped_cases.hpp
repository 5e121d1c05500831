#pragma once

#include "comparisons/accuracy/verification/verification_row.hpp"

namespace rebound {

/// Cases f and h, and a published case: the two lumped integrators against
/// closed forms and integrations at higher accuracy. Milliseconds.
VerificationTable verify_lumped();

/// Case e, lumped: Ting's foundation along two paths and in impacts at six
/// speeds, against tables. A second.
VerificationTable verify_viscoelastic_contact();

/// The error estimator against its published example.
VerificationTable verify_estimator();

}  // namespace rebound
