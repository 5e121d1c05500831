#pragma once

#include <string>

#include "comparisons/discrepancy/inspection/inspection.hpp"
#include "comparisons/io/report/report.hpp"
#include "comparisons/io/results/json.hpp"

namespace rebound {

/// What is seen in a data set for programs, terminals and readers.
///
/// JSON: schema, name, shots [{label, speed_m_s, speed_uncertainty_m_s, samples,
/// samples_in_contact, interval_s, noise_N, rounding_step_N, numbers {key: {value, uncertainty,
/// source}}, filters [{class, corner_Hz, peak_change}], too_coarse}], noise, repeats, checks,
/// contradictions, contradiction_limit, warnings, missing. What nothing tells is null.
Json to_json(const Inspection& inspection);
std::string to_text(const Inspection& inspection);

/// The page: contradictions first, then traces, numbers, noise, filters, repeats, all checks.
/// Of more than a dozen records a dozen are drawn, slowest to fastest, each of 400 samples at most.
report::Report inspection_report(const Inspection& inspection, const Dataset& dataset);

}  // namespace rebound
