#pragma once

#include "fem/interface/fem_problem.hpp"
#include "fem/interface/moduli.hpp"

namespace rebound::fem {

/// Range r of the traction, chosen where the problem leaves it open: where the
/// Tabor number is 0.1, but no less than R/100 and no more than R/10.
///
///   Tabor number (R w²/(E*² r³))^⅓,   E* = E/(1 − ν²),   0.1 at r = 10 (R w²/E*²)^⅓
///
/// At that number and below the pull is Derjaguin's, up to the end of contact.
double adhesive_range(const FemProblem& problem, const Moduli& instantaneous);

/// The problem's adhesion with that range.
AdhesiveTraction chosen_adhesion(const FemProblem& problem, const Moduli& instantaneous);

/// Errors: Error(bad_input) for a work or range outside its limits, a
///         range above R/4, or a traction at the plate above a tenth of E.
void check_adhesion(const FemProblem& problem, const Moduli& instantaneous);

}  // namespace rebound::fem
