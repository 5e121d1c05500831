#pragma once

#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"

namespace rebound {

/// A name that a lumped search has earned is asked of FE too, where the effect has a form there:
/// FE with nothing hidden and FE with the named effects are fitted to the same histories.
///
///   gain        χ² without the effect − χ² with it, all else fitted
///   supported   gain − k ln N of 6 at least, and half of what FE leaves over without it
///   rejected    no such gain, though FE follows the data without the effect
///   no-fit      FE follows these data neither with the effect nor without it: it cannot say
///
/// A name that FE rejects is withheld, and the verdict says that it depends on the tier; of what
/// several candidates have in common a warning says so.
///
/// Limit:  a plate under a ball of FE is supported; what is hidden in data of a lumped law, which
///         has no waves, is no-fit -> test BesideFem.AStiffPlateUnderABallOfFemIsNamed,
///         DiagnoseCommand.FindsWhatIsHiddenAndItsModelRuns.
/// Errors: Error(interrupted). Where FE has no answer, the tier stays "not-run", with a warning.
void ask_fem_of_names(Diagnosis& d, const Observations& all, const SelectionRules& rules,
                      const RunControl& control);

/// Is there a form in FE for an effect with these numbers? A free curve of unloading that grows
/// with the largest deflection has none there, and one that does not has.
bool fem_can_state(const EffectChoice& effect);

}  // namespace rebound
