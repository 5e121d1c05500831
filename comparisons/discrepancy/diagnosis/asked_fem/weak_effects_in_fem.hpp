#pragma once

#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"

namespace rebound {

/// Where a ball of FE with nothing hidden follows the data: does an effect beside it gain more than
/// one would where nothing is hidden?
///
/// A χ² of two thousand readings may pass where one number would bring a hundred. Every effect is
/// looked at to first order; those worth it are fitted in FE, each by itself. The best gives its
/// family where the unseen speed is followed better with it as well, and where effects of other
/// families plainly gain less; else the verdict is one of them.
///
/// Limit:  softening too weak for a gap is of its family
///         -> test BesideFem.AWeakSofteningIsSeenBesideFesOwnBall;
///         nothing is found where nothing is hidden -> test BesideFem.ImpactsOfFemLackNothing
/// Errors: those of FemOfBalls.
void look_for_weak_effects_in_fem(Diagnosis& d, const Observations& all, const RunControl& control);

}  // namespace rebound
