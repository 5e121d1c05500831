#include "comparisons/io/report/packed_values.hpp"

#include <openssl/evp.h>

#include <algorithm>
#include <cmath>

namespace rebound::report {
namespace {

std::string in_base64(const std::vector<unsigned char>& bytes) {
  std::vector<unsigned char> text((bytes.size() + 2) / 3 * 4 + 1);  // and a closing zero
  const int length = EVP_EncodeBlock(text.data(), bytes.data(), static_cast<int>(bytes.size()));
  return {text.begin(), text.begin() + length};
}

}  // namespace

std::string packed_values(const std::vector<std::vector<float>>& rows, const PackingRange& range) {
  std::vector<unsigned char> bytes;
  for (const auto& row : rows)
    for (const float value : row) {
      const double share = (value - range.low) / (range.high - range.low);
      bytes.push_back(static_cast<unsigned char>(std::lround(255.0 * std::clamp(share, 0.0, 1.0))));
    }
  return in_base64(bytes);
}

}  // namespace rebound::report
