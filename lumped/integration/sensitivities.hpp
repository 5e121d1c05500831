#pragma once

#include <string>
#include <vector>

#include "lumped/integration/direction.hpp"
#include "lumped/problem/lumped_problem.hpp"

namespace rebound {

/// What an impact comes to, taken from the motion itself rather than from samples.
struct ImpactOutcome {
  double restitution = 0.0;      ///< [-]
  double contact_time = 0.0;     ///< [s]
  double peak_force = 0.0;       ///< [N]
  double peak_deflection = 0.0;  ///< [m]
};

/// An impact with its derivatives by every parameter of the law, the mass and the speed.
struct Sensitivities {
  std::vector<std::string> by;  ///< names: parameters in the order of the card, "mass", "speed"
  ImpactOutcome outcome;
  std::vector<ImpactOutcome> slopes;              ///< of the outcome, one a name; SI over SI
  std::vector<double> time;                       ///< equally spaced over the contact [s]
  std::vector<double> force;                      ///< [N]
  std::vector<std::vector<double>> force_slopes;  ///< at fixed time, one column a name
};

/// Derivatives of one impact of a bare law, by the variational equations
///
///   δẋ = δv,   δv̇ = −(F_x δx + F_v δv + F_p)/m
///
/// `sensitivities_fast` carries them through the steps of the fast integrator;
/// `sensitivities` through SUNDIALS CVODES in x and t. The instant of separation moves with
/// the parameters: with g(x, v; p) = 0 there, δt* = −δg/ġ.
///
/// Valid:   laws without mechanisms, both separation rules.
/// Limit:   closed forms of Kelvin–Voigt and Hunt–Crossley
///          -> tests SensitivitiesTest.KelvinVoigtInClosedForm, HuntCrossleyInClosedForm;
///          each other and central differences -> test SensitivityBattery.
/// Caution: one-sided at a corner of a law (finite-sphere-hertz at a tabulated Poisson
///          ratio); force slopes at a first touch where the force jumps are those after it.
/// Errors:  as simulate(); Error(bad_input) for mechanisms beside the law.
Sensitivities sensitivities_fast(const LumpedProblem& problem);
Sensitivities sensitivities(const LumpedProblem& problem);

/// Every direction of a law, in the order of Sensitivities::by.
std::vector<Direction> all_directions(const std::string& law);
/// Errors: Error(bad_input) for a name the law does not have.
Direction direction_of(const std::string& law, const std::string& name);

}  // namespace rebound
