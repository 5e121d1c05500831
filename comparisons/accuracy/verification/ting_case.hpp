#pragma once

#include "comparisons/accuracy/verification/verification_part.hpp"
#include "fem/interface/modules.hpp"

namespace rebound {

/// Case e of the FE tier: standard linear solid (instantaneous 20, long-term
/// 10 MPa, τ 1 ms) pressed along a path of 1 mm in 4 ms, nine-node cells.
///
/// Target: Lee–Radok loading and Ting unloading, built on the elastic F(h) of
/// the same cells in place of k h^1.5:
///
///   loading    F(t) = ∫₀ᵗ ψ(t − s) dF_e(h(s)),        ψ(t) = ½ + ½ exp(−t/τ)
///   unloading  F(t) = ∫₀^t₁ ψ(t − s) dF_e(h(s)),      ∫_t₁ᵗ ψ(t − s) dh(s) = 0
///
/// exact for small strain; 1 mm of a radius of 33.1 mm is not quite: 0.7 % of
/// the peak while the contact grows, 1.0 % while it shrinks. Some four seconds.
/// Errors: those of FemTier::compress; Error(interrupted).
VerificationPart verify_ting(const FemTier& tier, CompressionPath path, const RunControl& control);

}  // namespace rebound
