#pragma once

#include <string>

#include "comparisons/evaluation/convert/conversion.hpp"

namespace rebound {

/// A law with one stiffness and one loss parameter, and what it is to return.
struct MatchRequest {
  LumpedProblem start;  ///< sphere, impact, law and parameters to start from
  std::string loss_parameter;
  Observed wanted;  ///< restitution, and contact time where there is one
};

/// The parameters at which the integrated law returns the wanted restitution
/// and contact time: a bracketed root in the loss, inside a secant in the
/// logarithm of the stiffness.
///
/// Valid:   restitution falls with the loss; contact time with the stiffness.
/// Limit:   recovers the parameters of a law from its own impact
///          -> test MatchedLawTest.RecoversEveryConvention.
/// Errors:  Error(solver_failed) where no parameters return what is wanted.
LumpedModel matched_law(const MatchRequest& request);

}  // namespace rebound
