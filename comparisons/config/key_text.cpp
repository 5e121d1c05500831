#include "comparisons/config/key_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "comparisons/config/units.hpp"

namespace rebound {

std::string joined(const std::vector<std::string>& names) {
  return fmt::format("{}", fmt::join(names, " | "));
}

std::string range_text(const Key& key) {
  const Range& range = key.range;
  const double factor = parse_unit(key.unit).factor();
  const bool low = std::isfinite(range.lowest);
  const bool high = std::isfinite(range.highest);
  const std::string tail = key.unit.empty() ? "" : " " + key.unit;
  if (low && range.lowest == range.highest)
    return fmt::format("{:.6g}{}", range.lowest / factor, tail);
  if (low && high)
    return fmt::format("{:.6g} {} value {} {:.6g}{}", range.lowest / factor,
                       range.lowest_allowed ? "<=" : "<", range.highest_allowed ? "<=" : "<",
                       range.highest / factor, tail);
  if (low)
    return fmt::format("value {} {:.6g}{}", range.lowest_allowed ? ">=" : ">",
                       range.lowest / factor, tail);
  if (high)
    return fmt::format("value {} {:.6g}{}", range.highest_allowed ? "<=" : "<",
                       range.highest / factor, tail);
  return key.unit.empty() ? "" : fmt::format("a number of {}", key.unit);
}

std::string allowed_text(const Key& key) {
  return key.allowed.empty() ? range_text(key) : joined(key.allowed);
}

}  // namespace rebound
