#pragma once

#include <string>

#include "comparisons/results/json.hpp"
#include "comparisons/selection/selection.hpp"

namespace rebound {

Json to_json(const Selection& selection);
std::string to_text(const Selection& selection);

}  // namespace rebound
