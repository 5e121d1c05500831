#include "comparisons/io/toml/key_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "comparisons/io/toml/units.hpp"

namespace rebound {

std::string joined(const std::vector<std::string>& names) {
  return fmt::format("{}", fmt::join(names, " | "));
}

std::string range_text(const Key& key) {
  return allowed_text(key.range, key.unit, parse_unit(key.unit).factor());
}

std::string allowed_text(const Key& key) {
  return key.allowed.empty() ? range_text(key) : joined(key.allowed);
}

}  // namespace rebound
