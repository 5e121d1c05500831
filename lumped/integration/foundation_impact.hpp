#pragma once

#include <vector>

#include "lumped/integration/closed_forms.hpp"

namespace rebound {

/// A sphere of a standard linear solid on a rigid plate, small strain, constant
/// Poisson ratio.
struct StandardLinearSphere {
  double stiffness = 0.0;        ///< long-term Hertz stiffness (4/3) E*_∞ √R [N/m^1.5]
  double ratio = 0.0;            ///< branch over long-term modulus [-]
  double relaxation_time = 0.0;  ///< τ [s]
  double radius = 0.0;           ///< R [m]
};

/// The contact of Lee & Radok (while the contact grows) and Ting (while it
/// shrinks), as a foundation of independent springs.
///
///   F = 2 ∫₀^a f dx,   f = E*_∞ (u + r q),   q̇ = u̇ − q/τ,   u = h − x²/R
///
///   x   place on the foundation [m]     h   approach [m]
///   f   force a length of one spring; it lets go where f would pull, and stays gone
///
/// That a half-space can be replaced so is exact for axisymmetric contact of a
/// linear viscoelastic body with constant Poisson ratio (method of
/// dimensionality reduction), growing or shrinking once.
///
/// Valid:   x ≪ R; one loading and one unloading.
/// Limit:   tables of Ting's integral solved separately, triangle and half-sine,
///          and of impacts at six speeds -> verification case e; ratio 0 is
///          Hertz -> test FoundationTest.WithoutBranchIsHertz.
/// Caution: a check, not a law of the list: it costs milliseconds. A force with
///          one internal state (mechanism "relaxation") is the same while the
///          contact grows, and not afterwards.
/// Source:  Lee & Radok 1960; Ting 1966; Popov & Hess 2013 for the foundation.
class ViscoelasticFoundation {
 public:
  ViscoelasticFoundation(const StandardLinearSphere& sphere, double largest_approach,
                         int springs = 4000);

  /// Force after the approach has moved linearly to h over dt [N].
  double advance(double approach, double dt);

 private:
  struct Spring {
    double gap = 0.0;  ///< x²/R [m]
    double u = 0.0;
    double q = 0.0;
    bool touched = false;
    bool gone = false;
  };

  StandardLinearSphere sphere_;
  double modulus_;  ///< E*_∞ [Pa]
  double spacing_;  ///< [m]
  double approach_ = 0.0;
  std::vector<Spring> springs_;
};

/// Impact of such a sphere; contact ends when the last spring lets go.
struct FoundationImpact {
  double restitution = 0.0;
  double contact_time = 0.0;     ///< [s]
  double peak_force = 0.0;       ///< [N]
  double peak_deflection = 0.0;  ///< [m]
  double end_deflection = 0.0;   ///< [m]
};

/// Errors: Error(solver_failed) when the contact does not end.
FoundationImpact foundation_impact(const StandardLinearSphere& sphere, const Approach& approach,
                                   int steps_per_contact = 4000);

}  // namespace rebound
