#pragma once

#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"
#include "comparisons/io/report/report.hpp"
#include "comparisons/io/results/provenance.hpp"

namespace rebound {

/// Verdict, gap, map, before-and-after pictures and candidates, ready to stand
/// among other sections; `name` tells several diagnoses of one page apart.
std::vector<report::Section> diagnosis_sections(const Diagnosis& diagnosis,
                                                const std::string& name);

/// The same as a page of its own.
report::Report diagnosis_report(const Diagnosis& diagnosis, const std::string& name,
                                const Provenance& provenance);

}  // namespace rebound
