#pragma once

#include "lumped/problem/lumped_problem.hpp"
#include "lumped/problem/result.hpp"

namespace rebound {

/// One impact of the lumped tier, m ẍ + F(x, ẋ) = 0, ẋ(0) = v₀, by CVODE.
///
/// The trace is equally spaced over [0, contact time], both ends included.
/// With mechanisms beside the law (`LumpedModel::mechanisms`) the contact is
/// composed of both, see ComposedContact; where a plate moves, `force` is what
/// the load cell reads and column "contact_force_N" stands beside it. Closures
/// are then those of the contact force and of all masses and losses.
///
/// Closures come from integrals carried as states, not from the samples:
///
///   impulse   |J − m (v₀ + v₁)| / (m (v₀ + v₁)),      J̇ = F
///   energy    |½ m v₁² + E(x₁) + D − ½ m v₀²| / ½ m v₀²,   Ḋ = F_d ẋ
///
/// Caution: J and v obey one linear equation, so the impulse closure sees a
///          wrong accounting, not an inaccurate step; the energy closure sees
///          both. Under the zero-force rule E(x₁) is energy the ball keeps and
///          loses later.
/// Errors:  Error(bad_input) for parameters (see make_law) and controls out of
///          range; Error(solver_failed) when the contact does not end.
LumpedResult simulate(const LumpedProblem& problem);

/// The same by the fast integrator: the same result within the tolerance,
/// some thirty times sooner; a composed contact in some 40 to 80 µs. Errors as simulate(), and
/// Error(solver_failed) where the contact is too stiff for explicit steps.
LumpedResult simulate_fast(const LumpedProblem& problem);

}  // namespace rebound
