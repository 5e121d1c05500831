#pragma once

#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"

namespace rebound {

/// What a lumped model leaves over may be no effect but what a body of finite size does: waves,
/// finite strain, loss that is no dashpot's. Measures what FE adds when nothing is hidden
/// (measure_model_discrepancy), and searches again with that in the model and in the errors of the
/// data, where
///
///   1 the lumped model with FE's own part is plainly nearer to the data than without, or FE
///     needs a plate that moves to come near (fit_own_balls), and
///   2 where effects have explained them, and no plate moves, explains half of what those do at
///     least.
///
/// The new search stands where it explains the data and its criterion, on the same errors, is no
/// worse than that of the effects: those it has replaced were FE's own part.
///
/// Where FE cannot be fitted the search stands as it was, with a warning.
/// Limit:  impacts of FE itself, of a Poisson ratio and a branch that the fit does not know, lack
///         nothing -> test BesideFem.ImpactsOfFemLackNothing.
/// Errors: Error(interrupted).
void search_beside_fem(Diagnosis& d, const DiagnosisRequest& request, const Hypothesis& believed,
                       const Observations& all, const RunControl& whole);

}  // namespace rebound
