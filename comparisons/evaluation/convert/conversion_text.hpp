#pragma once

#include <string>

#include "comparisons/evaluation/convert/conversion.hpp"
#include "comparisons/io/results/json.hpp"

namespace rebound {

/// null for what is not known.
Json to_json(const Observed& observed);
Json errors_json(const Observed& error);

Json to_json(const ConversionRequest& request, const ConversionTable& table);
std::string to_text(const ConversionRequest& request, const ConversionTable& table);

}  // namespace rebound
