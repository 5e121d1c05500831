#pragma once

#include "comparisons/discrepancy/diagnosis/fits/hypothesis_fit.hpp"

/// Where a fading memory is something else as far as one contact can tell.
///
///   F + q,  q̇ = s Ḟ_e − q/τ,  T contact time
///
///   τ ≪ T   q → s τ Ḟ_e: a damper whose coefficient follows the elastic stiffness. What differs is
///           of order (πτ/T)², 0.4 % at τ = T/50.
///   τ ≫ T   q → s (F_e − ∫F_e dt/τ): less force on the way back than on the way in, by an amount
///           that one hit a speed does not tell from a set or a loop of unloading.
///
/// Limit: a branch of T/100 and a dashpot that follows the stiffness leave the same trace
///        -> test LimitsOfMemoryTest.AFastBranchIsADamper.
namespace rebound {

/// Of effect k of a fit: its card's family, or rate for a memory that fades in less than a fiftieth
/// of the mean contact time.
EffectFamily acting_family(const Observations& seen, const HypothesisFit& fit, std::size_t k);

/// Has a fit one effect more than the first `known`, and is it a memory that fades in more than
/// five contact times?
bool is_slow_memory_alone(const Observations& seen, const HypothesisFit& fit, std::size_t known);

}  // namespace rebound
