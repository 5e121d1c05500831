#pragma once

#include <string>

#include "comparisons/evaluation/audit/audit.hpp"
#include "comparisons/io/results/json.hpp"

namespace rebound {

Json to_json(const Audit& audit);
std::string to_text(const Audit& audit);

}  // namespace rebound
