#pragma once

#include <string>

#include "comparisons/discrepancy/design/planned_experiments.hpp"
#include "comparisons/discrepancy/design/test_design.hpp"
#include "comparisons/io/report/report.hpp"
#include "comparisons/io/results/json.hpp"

namespace rebound {

/// With "schema": 1; sizes in SI, null where there is none. `counted` is empty where no experiments
/// were made.
Json to_json(const TestDesign& design, const std::vector<CountedChance>& counted);
std::string to_text(const TestDesign& design, const std::vector<CountedChance>& counted);
report::Report design_report(const TestDesign& design, const std::vector<CountedChance>& counted,
                             const std::string& name);

}  // namespace rebound
