#pragma once

#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"
#include "comparisons/io/report/report.hpp"
#include "comparisons/io/results/provenance.hpp"

namespace rebound {

/// What was measured of such verdicts, elsewhere: for the first screen, and for the section that
/// says how sure a verdict is.
struct MeasuredErrorRates {
  std::string sentence;  ///< empty: nothing was
  std::vector<report::Block> blocks;
};

/// A page in the order of its reader's questions: the verdict with its numbers and the gap at
/// each speed, before and after; where model and data disagree; what is missing; how sure that is.
report::Report diagnosis_report(const Diagnosis& diagnosis, const std::string& name,
                                const Provenance& provenance, MeasuredErrorRates error_rates = {});

}  // namespace rebound
