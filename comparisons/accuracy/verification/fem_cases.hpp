#pragma once

#include "comparisons/accuracy/verification/verification_part.hpp"
#include "fem/interface/modules.hpp"

/// Impacts and compressions of the FE tier with a known answer, and the
/// invariants of every impact. Errors: those of the tier; Error(solver_failed)
/// where a run does not complete; Error(interrupted).
namespace rebound {

/// Case a in time: both schemes are of second order in the step. Not with contact
/// that comes and goes: a flat end lands whole and stays.
VerificationPart verify_time_order(const FemTier& tier, const RunControl& control);

/// Case c: static contact on one plate and between two, Hertz with the
/// finite-sphere correction. By the nine-node cells.
VerificationPart verify_static_contact(const FemTier& tier, const RunControl& control);

/// Case d: impact of the elastic sphere, Hertz with the finite-sphere correction;
/// explicit at 0.1, 0.5 and 1 m/s, implicit at 1 m/s.
VerificationPart verify_sphere_impacts(const FemTier& tier, const RunControl& control);

/// Case d′: bar without lateral contraction on a wall, under refinement.
VerificationPart verify_bar(const FemTier& tier, const RunControl& control);

/// Two-body impact with a free plate: momentum, relative speed.
VerificationPart verify_free_plate(const FemTier& tier, const RunControl& control);

/// The invariants with every channel at work: branch, friction, gravity, a plate
/// on a spring and a damper.
VerificationPart verify_all_channels(const FemTier& tier, const RunControl& control);

/// Both schemes at 15 m/s, elastic and with one branch.
VerificationPart verify_schemes(const FemTier& tier, const RunControl& control);

/// The reference at 15 m/s: what its error bars are.
VerificationPart verify_error_bars(const FemTier& tier, const RunControl& control);

/// Published: a bar on a wall at 100 m/s, two spheres pressed together.
VerificationPart verify_published_contact(const FemTier& tier, const RunControl& control);

}  // namespace rebound
