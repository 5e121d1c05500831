#pragma once

#include <string>

#include "comparisons/discrepancy/design/test_design.hpp"
#include "comparisons/io/report/report.hpp"
#include "comparisons/io/results/json.hpp"

namespace rebound {

/// With "schema": 1; sizes in SI, null where there is none.
Json to_json(const TestDesign& design);
std::string to_text(const TestDesign& design);
report::Report design_report(const TestDesign& design, const std::string& name);

}  // namespace rebound
