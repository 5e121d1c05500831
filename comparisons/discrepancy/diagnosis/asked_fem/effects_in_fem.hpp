#pragma once

#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"

namespace rebound {

/// Where nothing lumped explains the data, and FE with nothing hidden comes nearer to them than
/// half of the lumped model's gap: the effects that have a form in FE, one at a time, fitted there
/// with the material (fit_fem_model).
///
/// One that pays by six in its criterion, takes half of what FE leaves over, leaves no more than
/// FE's own errors may, and does so at the unseen speed too, gives the data its family; the name is
/// withheld, since it depends on the tier. So do several of one family.
///
/// Where FE with nothing hidden leaves no more than noise, nothing is missing from the physics: the
/// data agree, with the gap that FE leaves, and a warning says what the lumped model leaves.
///
/// What swings is not looked for: a lumped model sees a plate as FE does.
/// Limit:  softening that is hidden in impacts of FE, which no lumped form follows, is of its
/// family
///         -> test BesideFem.SofteningInFemIsOfItsFamily.
/// Errors: Error(interrupted). Where FE has no answer the verdict stands as it was, with a warning.
void look_for_effects_in_fem(Diagnosis& d, const Observations& all, const SelectionRules& rules,
                             const RunControl& control);

}  // namespace rebound
