#pragma once

#include "fem/discretisation/discretisation.hpp"
#include "fem/interface/fem_problem.hpp"
#include "fem/interface/fem_result.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound::fem {

/// Runs one impact by explicit central differences with lumped mass.
///
///   v_{n+½} = v_{n−½} − ½ (Δtₙ₋₁ + Δtₙ) M⁻¹ f(uₙ)   (+ plate)
///   u_{n+1} = uₙ + Δtₙ v_{n+½}
///   Δt = s · 2/ω,   ω² ≤ max over cells of ω²_rest · growth(C)
///
///   M lumped mass [kg], f internal force [N], s step safety [-],
///   ω_rest eigenfrequency of the cell alone at rest, growth the bound of the
///   tangent over its value at rest (materials/*::stiffness_growth)
///
/// The run ends once the contact has ended for good: no force, the centre
/// moving away, and the gap larger than the vibration left in the body can
/// close.
///
/// Result: the trace (see ImpactRecorder), energies, closures. A result that
/// is not complete says why in `incomplete_because`: inversion of a cell, a
/// step below 1e-4 of the first one, a motion that is no longer finite, contact
/// that has not ended by the end time, or interruption.
/// Limit: elastic impact at low speed is Hertz with the finite-sphere
///        correction -> verification case d.
/// Error: that of the cell size; the stable step is far below what accuracy
///        asks. Restitution and deflection converge between first and second
///        order, constraint work in first; peak force and contact time carry
///        the ripple of the contact front -> test ImpactConvergence.
/// Errors: Error(bad_input) for numbers that are not positive and finite, the
///        zero-deflection rule, or more than 100000 samples a contact.
FemResult run_explicit_impact(const Discretisation& body, const FemProblem& problem,
                              const RunControl& control);

}  // namespace rebound::fem
