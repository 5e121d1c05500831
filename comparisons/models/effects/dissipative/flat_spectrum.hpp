#pragma once

#include "fem/interface/material.hpp"

namespace rebound {

/// What the long-term modulus becomes.
struct PowerLawRelaxation {
  double exponent = 0.0;        ///< s, 0 < s < 1 [-]
  double reference_time = 0.0;  ///< t_r, at which the modulus stays what it was [s]
};

/// Lets the long-term modulus of a material relax by a power of time, through a
/// flat spectrum of branches that relax all of the stress, one a decade:
///
///   E(t) = E∞ (t/t_r)^(−s) = E∞/Γ(s) ∫ (τ/t_r)^(−s) e^(−t/τ) d ln τ
///   τ_k = 1e-5, 1e-4, …, 10 s; what is slower stays as long-term modulus
///
/// scaled so that E(t_r) = E∞ exactly. Under a given rate the stiffness then grows as
/// rate^s. Other branches keep their moduli.
///
/// Valid:   1e-5 s < t < 10 s.
/// Limit:   s → 0 is the material as it was -> test FlatSpectrumTest.*
/// Errors:  Error(bad_input) outside 0 < s < 1, with more than 16 branches in all, or
///          where add_prony_branch refuses.
void relax_by_power_law(Material& material, const PowerLawRelaxation& law);

}  // namespace rebound
