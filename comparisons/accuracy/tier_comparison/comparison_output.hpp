#pragma once

#include <string>
#include <vector>

#include "comparisons/accuracy/tier_comparison/comparison.hpp"
#include "comparisons/io/report/report.hpp"
#include "comparisons/io/results/json.hpp"

namespace rebound {

/// JSON: schema, passes, cases [{name, passes, moved_tiers, records, movements [{tier, speed_m_s,
/// key, before, now, tolerance, bars, measured_by, moved}], gaps [{speed_m_s, key, lumped, fem,
/// tolerance, bars, allowed_share, fails}], remarks}].
Json to_json(const std::vector<CaseComparison>& cases);
std::string to_text(const std::vector<CaseComparison>& cases);
report::Report comparison_report(const std::vector<CaseComparison>& cases);

}  // namespace rebound
