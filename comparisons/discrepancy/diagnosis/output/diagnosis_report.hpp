#pragma once

#include <string>

#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"
#include "comparisons/io/report/report.hpp"
#include "comparisons/io/results/provenance.hpp"

namespace rebound {

/// A page in the order of its reader's questions: the verdict with its numbers and the gap at
/// each speed, before and after; where model and data disagree; what is missing; how sure that is.
report::Report diagnosis_report(const Diagnosis& diagnosis, const std::string& name,
                                const Provenance& provenance);

}  // namespace rebound
