#pragma once

#include <string>
#include <vector>

namespace rebound::report {

/// Values as eight bits each, in base64: byte = round(255 (value − low)/(high − low)),
/// held to 0…255. A colour shows no more, and a report stays small.
struct PackingRange {
  double low = 0.0, high = 1.0;
};
std::string packed_values(const std::vector<std::vector<float>>& rows, const PackingRange& range);

}  // namespace rebound::report
