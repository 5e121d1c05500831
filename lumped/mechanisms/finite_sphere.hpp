#pragma once

namespace rebound {

/// Compliance c of the ball outside the contact: centre-of-mass deflection is
///
///   x = δ − c F(δ),   c = s C(ν)/(E R),   E = (1 − ν²) F(x_r)/[(4/3) √R x_r^{3/2}],   x_r = R/10
///
///   δ   approach of the contact, what the law sees [m]
///   F   elastic force as it acts, any law          [N]
///   C   of one plate, finite_sphere_coefficient() of the laws [-]
///   E   modulus that Hertz reads from the force at x_r, of a Hertz law at any x [Pa]
///
/// Valid:   as long as 1 − c F′(δ) > 0.05; for Hertz up to x = 0.4 R. Beyond, the solver gives up.
/// Limit:   F at a given x is 20 % above Hertz at a/R = 0.2, ν = 0.4
///          -> test FiniteSphereTest.ForceAboveHertz.
/// Errors:  Error(bad_input) for ν outside 0.2 to 0.49.
/// Caution: first order, small strain: at a/R = 0.4 good to some per cent.
struct FiniteSphereRequest {
  double share = 1.0;            ///< s [-]
  double poisson_ratio = 0.4;    ///< ν [-]
  double radius = 0.0;           ///< R [m]
  double reference_force = 0.0;  ///< F(x_r) [N]
};
double body_compliance(const FiniteSphereRequest& request);

}  // namespace rebound
