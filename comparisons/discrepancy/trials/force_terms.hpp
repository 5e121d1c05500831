#pragma once

#include <string>
#include <vector>

#include "comparisons/models/effects/effect.hpp"
#include "lumped/problem/lumped_problem.hpp"
#include "lumped/problem/trace.hpp"

namespace rebound {

/// A term that a contact force may lack, of deflection and rate over their largest.
struct ForceTerm {
  const char* name;     ///< e.g. "x v"
  EffectFamily family;  ///< of the effects that have such a term
  double (*at)(double x, double v);
  bool in_contact;  ///< else it is added to the whole record, and the ball does not feel it
};

/// 1 in the whole record; in contact 1, x, x^1.5, x², x³, v, √x v, x v, v|v|, sgn v, x sgn v.
/// Caution: memory, and another mass that moves, are no functions of x and v.
const std::vector<ForceTerm>& force_terms();

/// What x and v are divided by.
struct MotionScales {
  double deflection = 1.0;  ///< [m]
  double rate = 1.0;        ///< [m/s]
};

/// How the force of an impact changes with one newton of a term, to first order.
///
///   δF = θ + F_x δx + F_v δv,   m δẍ = −δF,   δx(0) = δẋ(0) = 0
///
///   θ          the term along the impact as it was [N]
///   F_x, F_v   slopes of the contact law there [N/m, N s/m]
///
/// By Heun's steps from sample to sample.
/// Limit: a term that is the law's own is what more stiffness does
///        -> test ForceTermsTest.TheLawsOwnTermIsAChangeOfStiffness.
/// Caution: a law with a state of its own is taken without it.
/// Source: Dickinson & Gelinas 1976, J. Comput. Phys. 21, 123 (sensitivities of an ODE).
std::vector<double> force_response(const ForceTerm& term, const LumpedProblem& problem,
                                   const Trace& impact, const MotionScales& scales);

/// Rates of deflection of an impact, by differences over neighbouring samples [m/s].
std::vector<double> deflection_rates(const Trace& impact);

}  // namespace rebound
