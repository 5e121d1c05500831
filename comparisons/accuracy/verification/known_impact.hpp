#pragma once

#include <string>

#include "comparisons/accuracy/verification/verification_row.hpp"
#include "fem/interface/modules.hpp"

namespace rebound {

/// The ball of the verification suite (R = 33.1 mm, 89.6 g, 10 MPa, ν = 0.4), elastic.
FemProblem ball_problem(FemScheme scheme, double speed);

/// One impact that must complete.
/// Errors: Error(solver_failed) or Error(interrupted), naming the impact.
FemResult complete_impact(const FemTier& tier, const FemProblem& problem, const Mesh& mesh,
                          const RunControl& control, const std::string& name);

/// The same for any run: throws when `incomplete_because` is not empty.
void require_complete(const std::string& incomplete_because, const RunControl& control,
                      const std::string& name);

/// Momentum, energy and restitution of one impact, each against itself.
VerificationTable invariants_of(const FemResult& result, const std::string& name);

/// What the contact constraint took of the kinetic energy: at most 3e-3.
VerificationRow constraint_row(const FemResult& result, const std::string& name);

}  // namespace rebound
