#pragma once

namespace rebound {

/// A whole sphere squeezed slowly between two platens, and the power law that
/// was fitted to it.
struct PlatenTest {
  double stiffness = 0.0;        ///< κ of F = κ x^1.5, x the travel of the platens [N/m^1.5]
  double diameter = 0.0;         ///< [m]
  double poisson_ratio = 0.0;    ///< [-]
  double shortest_travel = 0.0;  ///< range of travel that the fit used [m]
  double longest_travel = 0.0;
};

/// Young's modulus of a sphere from its compression between two platens.
///
///   per contact, δ = x/2:   δ = δ_H(F) − C F/(E R)
///   δ_H = [3 (1 − ν²) F/(4 E √R)]^(2/3),   C(ν) of two platens
///
///   F force [N], x travel [m], R radius [m], ν Poisson ratio,
///   C finite-sphere coefficient [-]
///
/// E is the modulus whose F(x), fitted as κ x^1.5 by least squares over the
/// same range of travel, gives the κ that was measured.
/// Valid:   linear elasticity, contact radius below 0.4 R, 0.2 ≤ ν ≤ 0.49.
/// Limit:   C → 0 gives E = ¾ (1 − ν²) 2^1.5 κ/√R
///          -> test PlatenModulusTest.WithoutCorrectionIsHertz.
/// Errors:  Error(bad_input) for ν outside the table or an empty range.
/// Source:  C: axisymmetric linear-elastic computations of a sphere between
///          platens at a/R = 0.2, ν = 0.2 … 0.49, scatter ±0.005; Tatara
///          (1991) agrees at ν = 0.3 within 1 %.
double modulus_from_platens(const PlatenTest& test);

/// The same without the finite-sphere correction: Hertz alone.
double modulus_from_platens_hertz(const PlatenTest& test);

}  // namespace rebound
