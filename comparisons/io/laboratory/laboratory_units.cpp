#include "comparisons/io/laboratory/laboratory_units.hpp"

#include <array>
#include <cctype>
#include <utility>

#include "comparisons/io/text.hpp"
#include "comparisons/io/toml/units.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr double foot = 0.3048, inch = 0.0254, mile = 1609.344, pound = 0.45359237;
constexpr double free_fall = 9.80665;

struct NamedUnit {
  std::string_view name;
  LaboratoryUnit unit;
};

constexpr NamedUnit named_units[] = {
    {"sec", {1.0, dimension::time}},
    {"msec", {1e-3, dimension::time}},
    {"usec", {1e-6, dimension::time}},
    {"min", {60.0, dimension::time}},
    {"in", {inch, dimension::length}},
    {"mil", {1e-3 * inch, dimension::length}},
    {"thou", {1e-3 * inch, dimension::length}},
    {"yd", {3.0 * foot, dimension::length}},
    {"inch", {inch, dimension::length}},
    {"ft", {foot, dimension::length}},
    {"oz", {pound / 16.0, dimension::mass}},
    {"lb", {pound, dimension::mass}},
    {"lbm", {pound, dimension::mass}},
    {"lbf", {pound * free_fall, dimension::force}},
    {"ozf", {pound / 16.0 * free_fall, dimension::force}},
    {"kgf", {free_fall, dimension::force}},
    {"gf", {1e-3 * free_fall, dimension::force}},
    {"pond", {1e-3 * free_fall, dimension::force}},
    {"dyn", {1e-5, dimension::force}},
    {"kp", {free_fall, dimension::force}},
    {"mph", {mile / 3600.0, dimension::speed}},
    {"km/h", {1.0 / 3.6, dimension::speed}},
    {"kmh", {1.0 / 3.6, dimension::speed}},
    {"kph", {1.0 / 3.6, dimension::speed}},
    {"ft/s", {foot, dimension::speed}},
    {"fps", {foot, dimension::speed}},
    {"in/s", {inch, dimension::speed}},
    {"ft/s^2", {foot, dimension::acceleration}},
    {"in/s^2", {inch, dimension::acceleration}},
    {"gn", {free_fall, dimension::acceleration}},
    {"G", {free_fall, dimension::acceleration}},
    {"gee", {free_fall, dimension::acceleration}},
    {"kg_f", {free_fall, dimension::force}},
    {"newton", {1.0, dimension::force}},
    {"newtons", {1.0, dimension::force}},
    {"seconds", {1.0, dimension::time}},
    {"%", {1e-2, dimension::none}},
    {"-", {1.0, dimension::none}},
    {"1", {1.0, dimension::none}},
};

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

/// One spelling of what is written in many: "m/s²", "m/s2", "m s^-2", "m·s⁻²" and "m_s2".
std::string one_spelling(std::string_view written) {
  std::string text(trimmed(written));
  const std::pair<std::string_view, std::string_view> same[] = {
      {"\u207b", "-"}, {"\u00b9", "1"}, {"\u00b2", "2"},    {"\u00b3", "3"},   {"**", "^"},
      {"\u00b7", "."}, {"*", "."},      {"m_s^2", "m/s^2"}, {"m_s2", "m/s^2"}, {"m_s", "m/s"},
      {"s2", "s^2"},   {"s.-", "s^-"},  {"s-2", "s^-2"},    {"s-1", "s^-1"},   {" ", "."}};
  for (const auto& [from, to] : same) text = replaced(text, from, to);
  text = replaced(text, ".s^-2", "/s^2");
  return replaced(text, ".s^-1", "/s");
}

/// Splits a heading before a unit that ends it, where there is one.
std::optional<ColumnHeading> split_at(std::string_view text, std::size_t at, std::size_t skipped) {
  const std::string_view name = trimmed(text.substr(0, at));
  const std::string_view unit = trimmed(text.substr(at + skipped));
  if (name.empty() || unit.empty()) return std::nullopt;
  const auto found = find_unit(unit);  // "shot_1" is a name, not a shot in units of 1
  if (!found || same_dimension(found->dimension, dimension::none)) return std::nullopt;
  return ColumnHeading{std::string(text), std::string(name), std::string(unit)};
}

}  // namespace

std::optional<LaboratoryUnit> find_unit(std::string_view text,
                                        const std::optional<Dimension>& wanted) {
  const std::string unit = one_spelling(text);
  if (unit.empty()) return std::nullopt;
  if (unit == "g" && wanted && same_dimension(*wanted, dimension::acceleration))
    return LaboratoryUnit{free_fall, dimension::acceleration};
  for (const NamedUnit& known : named_units)
    if (known.name == unit) return known.unit;
  try {
    const Unit parsed = parse_unit(unit);
    return LaboratoryUnit{parsed.factor(), parsed.dimension};
  } catch (const Error&) {
    return std::nullopt;
  }
}

ColumnHeading parse_heading(std::string_view written) {
  const std::string_view text = trimmed(written);
  for (const auto& [opens, closes] : {std::pair{'[', ']'}, std::pair{'(', ')'}}) {
    const auto open = text.rfind(opens);
    if (open == std::string_view::npos || !text.ends_with(closes)) continue;
    const std::string_view inside = text.substr(open + 1, text.size() - open - 2);
    if (!find_unit(inside)) continue;
    return {std::string(text), std::string(trimmed(text.substr(0, open))),
            std::string(trimmed(inside))};
  }
  // The first place after which all is a unit: "speed_m_s" is a speed in m/s, not a "speed_m" in s.
  for (std::size_t at = 1; at < text.size(); ++at) {
    const char mark = text[at];
    if (mark != '_' && mark != '/' && mark != ',' && mark != ' ') continue;
    if (auto heading = split_at(text, at, 1)) return *heading;
  }
  return {std::string(text), std::string(text), ""};
}

}  // namespace rebound
