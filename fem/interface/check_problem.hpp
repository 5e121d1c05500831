#pragma once

#include "fem/interface/compression.hpp"
#include "fem/interface/fem_problem.hpp"
#include "fem/interface/moduli.hpp"

namespace rebound {

/// Holds a problem to the limits of its numbers, and to what they must be together:
///
///   impact        separation by zero force; adhesion that the radius and E bear; an output
///                 interval of a 100000th of the contact time and more; what the implicit
///                 scheme has no part for; the material's own rules
///   compression   at most 0.6 radii a plate; a duration where the path has one, and only
///                 there; a material of elastic law and branches by convolution
///
/// The solvers call it, and so does the reader of a file, which adds file and line.
/// Errors: Error(bad_input) with the full path of the key, its value and what is allowed.
void check(const FemProblem& problem);
void check(const CompressionProblem& problem);

/// Refuses a problem that the implicit scheme has no part for, whatever its `scheme`.
void check_implicit(const FemProblem& problem);

namespace fem {

/// Contact time of the Hertz impact with the instantaneous modulus [s]: only
/// the yardstick of default output interval and end time.
double expected_contact_time(const FemProblem& problem, const Moduli& moduli);

/// Averaging windows of the peak force in that time: 20 µs for a ball of 66.2 mm, 89.6 g,
/// 10 MPa, ν = 0.4 at 15 m/s.
inline constexpr double windows_per_contact = 93.0;

/// Largest contact radius of the same impact [m]: what a mesh has to resolve.
///
///   a = √(R δ),   δ^(5/2) = (15/16) m v²/(E* √R)
///
/// Limit: that of FE to the width of a cell, at 0.5 and at 15 m/s
///        -> test MeshForTest.ExpectsTheRadiusThatFeFinds
double expected_contact_radius(const FemProblem& problem, const Moduli& moduli);

}  // namespace fem
}  // namespace rebound
