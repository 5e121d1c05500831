#pragma once

#include <string>

#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"
#include "comparisons/discrepancy/diagnosis/output/diagnosis_report.hpp"
#include "comparisons/io/results/json.hpp"

namespace rebound {

/// For programs: one object for balls that obey a law, one for balls in finite elements.
Json error_rates_json(const Diagnosis& diagnosis);

/// Lines of a terminal; empty where nothing was measured.
std::string error_rates_text(const Diagnosis& diagnosis);

/// For the page of a diagnosis.
MeasuredErrorRates error_rates_on_page(const Diagnosis& diagnosis);

}  // namespace rebound
