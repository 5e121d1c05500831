#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lumped/problem/dimension.hpp"

namespace rebound {

/// A unit as a laboratory writes it: one of it in SI.
struct LaboratoryUnit {
  double factor = 1.0;
  Dimension dimension;
};

/// Reads "kN", "m/s²", "m/s2", "m s^-1", "mph", "in", "lbf", "msec", "%" and what parse_unit()
/// knows. `wanted` decides between the gram and the standard acceleration of free fall, both
/// written "g".
///
/// Error: nothing for text that is no unit.
/// Source: factors of yard, pound, mile and gₙ = 9.80665 m/s² are exact by definition (NIST SP
/// 811).
std::optional<LaboratoryUnit> find_unit(std::string_view text,
                                        const std::optional<Dimension>& wanted = {});

/// A column's heading taken apart: "Force [kN]" is "Force" in "kN".
struct ColumnHeading {
  std::string text;  ///< as written
  std::string name;  ///< without its unit
  std::string unit;  ///< as written; empty: none is stated
};

/// Takes a heading apart: "Force [kN]", "Force (kN)", "Force / kN", "Force, kN", "force_kN",
/// "force_m_s2". Text that is no unit stays part of the name.
ColumnHeading parse_heading(std::string_view text);

}  // namespace rebound
