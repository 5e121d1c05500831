#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "comparisons/inference/calibration/observations.hpp"

namespace rebound {

/// Reduced χ² up to which a fit is said to hold its data: two standard deviations each.
inline constexpr double agreeing = 4.0;

/// "contact time".
inline std::string in_words(ObservedQuantity what) {
  switch (what) {
    case ObservedQuantity::restitution: return "restitution";
    case ObservedQuantity::contact_time: return "contact time";
    case ObservedQuantity::peak_force: return "peak force";
    case ObservedQuantity::peak_deflection: return "peak deflection";
    case ObservedQuantity::mean_deflection: return "mean deflection";
    default: return name_of(what);
  }
}

inline const char* direction_in_words(ObservedQuantity what, bool above) {
  if (what == ObservedQuantity::contact_time) return above ? "longer" : "shorter";
  return above ? "larger" : "smaller";
}

/// "+16 to +26 %".
inline std::string percent_range(const std::vector<double>& percent) {
  const auto [least, most] = std::minmax_element(percent.begin(), percent.end());
  return *least == *most ? fmt::format("{:+.0f} %", *least)
                         : fmt::format("{:+.0f} to {:+.0f} %", *least, *most);
}

}  // namespace rebound
