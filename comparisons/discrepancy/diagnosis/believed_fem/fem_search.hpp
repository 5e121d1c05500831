#pragma once

#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"

namespace rebound {

/// Effects beside a believed FE model: fills the judged belief, the selection, the observations
/// with the numerical errors of the mesh, and warnings of `d`.
///
/// Where no single effect explains the data, the mesh is settled anew at the one that comes
/// nearest: an effect that takes energy changes what a finer mesh adds. All are then tried again,
/// in sets of two at most.
///
/// Limit:  data of FE itself with one effect more than the belief
///         -> test BelievedFemTest.ABranchThatIsMissingIsNamed.
/// Errors: those of settle_fem() and select_effects().
void search_in_fem(Diagnosis& d, const DiagnosisRequest& request, const Observations& all,
                   const RunControl& whole);

}  // namespace rebound
