#pragma once

#include "comparisons/config/visitor.hpp"
#include "comparisons/convert/conversion.hpp"

namespace rebound {

void describe(Visitor& visit, Given& given);

/// What `rebound convert FILE` reads.
void describe(Visitor& visit, ConversionRequest& request);

}  // namespace rebound
