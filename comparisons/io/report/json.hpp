#pragma once

#include <nlohmann/json.hpp>

#include "comparisons/io/report/report.hpp"

namespace rebound::report {

/// The report as the one JSON object the page's renderer reads ("schema": 1). Each
/// block carries its "kind". Numbers round-trip.
nlohmann::json report_json(const Report& report);

}  // namespace rebound::report
