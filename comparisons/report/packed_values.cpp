#include "comparisons/report/packed_values.hpp"

#include <algorithm>
#include <cmath>

namespace rebound::report {
namespace {

constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::string in_base64(const std::vector<unsigned>& bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto at = [&](std::size_t k) { return i + k < bytes.size() ? bytes[i + k] : 0u; };
    const unsigned group = at(0) << 16 | at(1) << 8 | at(2);
    text += digits[group >> 18];
    text += digits[group >> 12 & 63u];
    text += i + 1 < bytes.size() ? digits[group >> 6 & 63u] : '=';
    text += i + 2 < bytes.size() ? digits[group & 63u] : '=';
  }
  return text;
}

}  // namespace

std::string packed_values(const std::vector<std::vector<float>>& rows, const PackingRange& range) {
  std::vector<unsigned> bytes;
  for (const auto& row : rows)
    for (const float value : row) {
      const double share = (value - range.low) / (range.high - range.low);
      bytes.push_back(static_cast<unsigned>(std::lround(255.0 * std::clamp(share, 0.0, 1.0))));
    }
  return in_base64(bytes);
}

}  // namespace rebound::report
