#pragma once

#include <string>

#include "comparisons/audit/audit.hpp"
#include "comparisons/results/json.hpp"

namespace rebound {

Json to_json(const Audit& audit);
std::string to_text(const Audit& audit);

}  // namespace rebound
