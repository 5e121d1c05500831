#pragma once

#include <cmath>

#include "lumped/laws/contact_law.hpp"
#include "lumped/problem/impact.hpp"

namespace rebound {

/// Hertz contact of a sphere that is not a half-space: the body around the
/// contact squashes too, so its centre of mass moves less than Hertz's approach.
///
///   x = δ_H(F_e) − C F_e/(E R),   δ_H = (F_e/κ)^{2/3}
///   F = F_e(x) + A F_e′(x) ẋ
///
///   κ   stiffness, (4/3) E/(1−ν²) √R             [N/m^1.5]
///   A   dissipation time, as in KuwabaraKono     [s]
///   R   radius; 0 stands for the sphere's own    [m]
///   ν   Poisson ratio, which sets C and E        [-]
///   C   finite-sphere coefficient of one plate: 0.374 at ν = 0.4  [-]
///
/// With g = (4/3) C/(1−ν²) √(x/R) and w the root of w³ − w + g = 0 near 1:
/// F_e = κ x^{3/2}/w³. Beyond g = 0.3 (x/R about a quarter) F_e goes on as the
/// power of x that touches it there, exponent 2.2.
///
/// Valid:   linear elasticity, contact radius below 0.4 R, quasi-static body.
/// Limit:   C → 0, that is R → ∞, is KuwabaraKono
///          -> test FiniteSphereHertzTest.LargeSphereIsKuwabaraKono; elastic
///          impacts at 0.1 to 1 m/s -> test FiniteSphereHertzTest.ElasticImpacts.
/// Caution: a real ball at finite strain stiffens less steeply than this. Strain is of the
///          order of the correction, so that C belongs to the whole stress law and not to ν
///          alone: at a/R = 0.05, ν = 0.4, FE finds 0.35 for a neo-Hookean ball, 0.30 and
///          0.46 for hyperfoams of exponent 8 and -8 with the same moduli
///          -> test VerificationCaseC.TheCorrectionBelongsToTheLawAndHertzToAll.
/// Source:  C: axisymmetric linear-elastic computations of a sphere on one
///          plate, load balanced by a uniform body force, at a/R = 0.2; scatter
///          ±0.005. Tatara 1991 for the form.
struct FiniteSphereHertz {
  double stiffness = 0.0;
  double dissipation_time = 0.0;
  double correction = 0.0;       ///< g/√x [m^-0.5]
  double last_deflection = 0.0;  ///< where the power law takes over [m]
  double radius = 1.0;           ///< R [m]
  double poisson_slope = 0.0;    ///< d ln g/dν [-]

  static LawCard card();
  static FiniteSphereHertz from(const ParameterValues& values);
  /// Puts the sphere's radius where none (0) was given.
  static void complete(ParameterValues& values, const Sphere& sphere);

  /// Elastic force at |x| and its logarithmic slope n = d ln F_e/d ln x.
  struct Elastic {
    double force = 0.0;           ///< [N]
    double exponent = 1.5;        ///< [-]
    double exponent_slope = 0.0;  ///< dn/d ln x [-]
  };
  /// `root` is √|x|.
  Elastic elastic_at(double root) const;
  Elastic elastic(double x) const { return elastic_at(std::sqrt(x)); }

  double elastic_force(double x) const { return std::copysign(elastic(std::abs(x)).force, x); }
  double damping_force(double x, double v) const {
    return slope(std::abs(x)) * dissipation_time * v;
  }
  double force(double x, double v) const {
    const double size = std::abs(x);
    if (size == 0.0) return 0.0;
    const Elastic e = elastic(size);
    return std::copysign(e.force, x) + e.exponent * e.force / size * dissipation_time * v;
  }
  ForceSlopes at_root(double u, double v) const;
  double slope_by(std::size_t parameter, double u, double v) const;
  double elastic_energy(double x) const;

 private:
  double slope(double x) const {
    if (x == 0.0) return 0.0;
    const Elastic e = elastic(x);
    return e.exponent * e.force / x;
  }
};

/// C(ν) of one plate, linear between ν = 0.2, 0.3, 0.4, 0.45 and 0.49.
/// Errors: Error(bad_input) outside that range.
double finite_sphere_coefficient(double poisson_ratio);

static_assert(ContactLaw<FiniteSphereHertz>);

}  // namespace rebound
