#pragma once

#include <array>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lumped/problem/trace.hpp"

namespace rebound {

/// Scalars that are kept of an impact, by their names in files.
inline constexpr std::array<const char*, 10> member_scalars{
    "restitution",       "contact_time_s",      "contact_time_1pct_s", "peak_force_N",
    "peak_deflection_m", "mean_deflection_m",   "rebound_speed_m_s",   "impulse_closure",
    "energy_closure",    "restitution_momentum"};

/// A number or a text that a member gave, by its name in a table; NaN is no number.
struct NamedValue {
  std::string name;
  std::variant<double, std::string> value;
};

/// What one member gave: an impact its scalars, any other member values with names of their own. A
/// member that has no result says why, and that is its result: the same input gives the same
/// refusal.
struct MemberResult {
  std::array<double, member_scalars.size()> scalars{};  ///< NaN: the tier has no such scalar
  std::vector<NamedValue> values{};                     ///< of a member that is no impact
  std::string failure{};                                ///< empty: it ran
  std::vector<TraceColumn> trace{};                     ///< where traces are kept
};

/// What a result is kept under: 32 digits of the SHA-256 of all that it depends on.
std::string member_key(std::string_view content);

/// The value of that name; null: the member has none.
const NamedValue* value_named(const MemberResult& member, std::string_view name);

/// What a campaign was made of, to be read again without its files.
struct CampaignText {
  std::string file, text;            ///< of the campaign
  std::string base_file, base_text;  ///< of what it varies
};

}  // namespace rebound
