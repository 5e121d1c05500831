#pragma once

#include <string>

#include "comparisons/inference/selection/selection.hpp"
#include "comparisons/io/results/json.hpp"

namespace rebound {

Json to_json(const Selection& selection);
std::string to_text(const Selection& selection);

}  // namespace rebound
