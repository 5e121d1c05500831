#pragma once

#include <string>

#include "comparisons/convert/conversion.hpp"
#include "comparisons/results/json.hpp"

namespace rebound {

Json to_json(const ConversionRequest& request, const ConversionTable& table);
std::string to_text(const ConversionRequest& request, const ConversionTable& table);

}  // namespace rebound
