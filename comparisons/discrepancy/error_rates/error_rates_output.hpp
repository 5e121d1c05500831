#pragma once

#include <string>

#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"
#include "comparisons/discrepancy/diagnosis/output/diagnosis_report.hpp"
#include "comparisons/io/results/json.hpp"

namespace rebound {

/// A whole diagnosis for programs: to_json() with `error_rates`, one object for balls that obey a
/// law and one for balls in finite elements.
Json json_with_error_rates(const Diagnosis& diagnosis);

/// Lines of a terminal; empty where nothing was measured.
std::string error_rates_text(const Diagnosis& diagnosis);

/// For the page of a diagnosis.
MeasuredErrorRates error_rates_on_page(const Diagnosis& diagnosis);

}  // namespace rebound
