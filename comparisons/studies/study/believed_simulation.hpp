#pragma once

#include <optional>
#include <vector>

#include "comparisons/discrepancy/consistency/joint_scalars.hpp"
#include "comparisons/studies/study/core_study.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound {

/// Believes the FE model of a study and holds it against all scalars of every core: fills
/// `scalars` of the cores, those first that come first.
///
/// The believed material has the elastic law, Poisson ratio and first branch of the study file; the
/// modulus from the platens is where its search starts. All its numbers are fitted anew, to mean
/// deflection and pooled peaks too, which the material of the references never sees.
///
/// Cores with fewer scalars than that needs are left as they are. Returned is what the others say
/// together, where there are two or more.
/// Errors: those of diagnose_scalars(), but for too few data.
std::optional<JointScalars> diagnose_simulation(const StudyFem& fem, std::vector<CoreStudy>& cores,
                                                const RunControl& control);

/// Those that have been diagnosed, in the order of the file: the balls of the joint diagnosis.
std::vector<const CoreStudy*> diagnosed_cores(const std::vector<CoreStudy>& cores);

/// Did the effect that comes nearest take half of the excess gap at the speed no fit saw, as
/// diagnose() asks of a name?
bool earns_a_name(const ScalarDiagnosis& d);

}  // namespace rebound
