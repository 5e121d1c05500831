#pragma once

#include "comparisons/evaluation/convert/conversion.hpp"
#include "comparisons/io/toml/visitor.hpp"

namespace rebound {

void describe(Visitor& visit, Given& given);

/// What `rebound convert FILE` reads.
void describe(Visitor& visit, ConversionRequest& request);

}  // namespace rebound
