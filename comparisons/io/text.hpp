#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace rebound {

/// The text without blanks and tabulators at either end.
inline std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// A key as words: "relaxation_time" is "relaxation time".
inline std::string with_blanks(std::string key) {
  std::replace(key.begin(), key.end(), '_', ' ');
  return key;
}

}  // namespace rebound
