#pragma once

#include "fem/interface/material.hpp"

namespace rebound {

/// Adds a branch that relaxes all of the stress, `ratio` over the long-term
/// modulus, whatever the state the material is described in. Long-term moduli
/// and the other branches stay what they are.
///
///   instantaneous, all branches "all":  E₀' = E₀ + s E∞,  gᵢ' = gᵢ E₀/E₀',  g = s E∞/E₀'
///   instantaneous, all "deviator":      rewritten as long-term: μ∞ = μ₀ (1 − Σ gᵢ),  K∞ = K₀
///
/// Limit:  moduli before and after -> test PronyBranchTest.LongTermModuliStay.
/// Errors: Error(bad_input) for an instantaneous description whose branches
///         relax partly all and partly the deviator: shares of one modulus
///         cannot say the same of both moduli; describe it as long-term.
void add_prony_branch(Material& material, const PronyBranch& branch);

/// Describes the same material by its long-term state.
/// Errors: as add_prony_branch.
void describe_as_long_term(Material& material);

}  // namespace rebound
