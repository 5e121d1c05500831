#include "comparisons/io/toml/units.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "comparisons/io/text.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

struct Symbol {
  std::string_view name;
  Unit unit;
};

constexpr std::array<Symbol, 8> symbols{{
    {"1", {0, dimension::none}},  // as in 1/s
    {"m", {0, dimension::length}},
    {"s", {0, dimension::time}},
    {"g", {-3, dimension::mass}},
    {"N", {0, dimension::force}},
    {"Pa", {0, dimension::pressure}},
    {"Hz", {0, dimension::frequency}},
    {"J", {0, {1, 2, -2}}},
}};

/// Both code points that are printed as µ are accepted.
constexpr std::array<std::pair<std::string_view, int>, 9> prefixes{{
    {"k", 3},
    {"M", 6},
    {"G", 9},
    {"c", -2},
    {"m", -3},
    {"u", -6},
    {"\u00b5", -6},
    {"\u03bc", -6},
    {"n", -9},
}};

[[noreturn]] void refuse(const std::string& message) {
  throw Error(ExitCode::bad_input, message);
}

std::optional<Unit> find_symbol(std::string_view name) {
  for (const Symbol& symbol : symbols)
    if (symbol.name == name) return symbol.unit;
  return std::nullopt;
}

Unit parse_symbol(std::string_view name) {
  if (const auto unit = find_symbol(name)) return *unit;
  for (const auto& [prefix, exponent] : prefixes) {
    if (!name.starts_with(prefix)) continue;
    if (auto unit = find_symbol(name.substr(prefix.size()))) {
      unit->power_of_ten += exponent;
      return *unit;
    }
  }
  refuse(fmt::format(
      "\"{}\" is not a unit known here (m s g N Pa Hz J, with prefixes k M G c m u µ n)", name));
}

/// The whole of `text` as a number, or nothing.
std::optional<double> whole_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0.0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

Unit parse_atom(std::string_view atom) {
  const auto caret = atom.find('^');
  Unit unit = parse_symbol(atom.substr(0, caret));
  if (caret == std::string_view::npos) return unit;
  const auto exponent = whole_number(atom.substr(caret + 1));
  if (!exponent) refuse(fmt::format("\"{}\" has an exponent that is not a number", atom));
  return {unit.power_of_ten * *exponent, power(unit.dimension, *exponent)};
}

/// End of the atom that starts at `start`. A '.' inside an exponent is a
/// decimal point when digits stand on both sides of it.
std::size_t atom_end(std::string_view text, std::size_t start) {
  bool in_exponent = false;
  for (std::size_t i = start; i < text.size(); ++i) {
    if (text[i] == '/') return i;
    if (text[i] == '^') in_exponent = true;
    const bool digit_follows = i + 1 < text.size() && text[i + 1] >= '0' && text[i + 1] <= '9';
    if (text[i] == '.' && !(in_exponent && digit_follows)) return i;
  }
  return text.size();
}

/// mantissa × 10^power with one rounding where the power is whole.
std::optional<double> scaled(std::string_view number, double power_of_ten) {
  const double rounded = std::round(power_of_ten);
  const auto plain = whole_number(number);
  if (!plain) return std::nullopt;
  if (rounded != power_of_ten) {
    const double value = *plain * std::pow(10.0, power_of_ten);
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
  }
  long exponent = static_cast<long>(rounded);
  const auto e = number.find_first_of("eE");
  if (e != std::string_view::npos)
    exponent += std::lround(whole_number(number.substr(e + 1)).value_or(0.0));
  return whole_number(fmt::format("{}e{}", number.substr(0, e), exponent));
}

}  // namespace

double Unit::factor() const {
  return std::pow(10.0, power_of_ten);
}

Unit parse_unit(std::string_view text) {
  Unit result;
  bool divides = false;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = atom_end(text, start);
    const Unit atom = parse_atom(text.substr(start, end - start));
    const double sign = divides ? -1.0 : 1.0;
    result.power_of_ten += sign * atom.power_of_ten;
    result.dimension = result.dimension * power(atom.dimension, sign);
    if (end == text.size()) break;
    if (end + 1 == text.size()) refuse(fmt::format("the unit \"{}\" ends early", text));
    if (text[end] == '/') divides = true;
    start = end + 1;
  }
  return result;
}

double parse_quantity(std::string_view text, const Dimension& expected) {
  const std::string_view body = trimmed(text);
  const std::string_view number = body.substr(0, body.find_first_of(" \t"));
  const std::string_view unit_text = trimmed(body.substr(number.size()));
  if (number.find(',') != std::string_view::npos)
    refuse(fmt::format("\"{}\" has a comma; write a decimal point", text));
  if (!whole_number(number))
    refuse(fmt::format("\"{}\" is not a finite number, a space and a unit", text));
  if (unit_text.empty() && !same_dimension(expected, dimension::none))
    refuse(fmt::format("\"{}\" has no unit", text));
  const Unit unit = parse_unit(unit_text);
  if (!same_dimension(unit.dimension, expected))
    refuse(fmt::format(
        "\"{}\" is in {}, which is not a multiple of {}", text, unit_text,
        same_dimension(expected, dimension::none) ? "a plain number" : unit_name(expected)));
  const auto value = scaled(number, unit.power_of_ten);
  if (!value) refuse(fmt::format("\"{}\" is too large a number", text));
  return *value;
}

std::string format_number(double value) {
  return fmt::format("{}", value);
}

std::string format_quantity(double value, std::string_view unit_text) {
  const Unit unit = parse_unit(unit_text);
  if (unit_text.empty()) return format_number(value);
  for (const int digits : {6, 9, 12, 15, 16, 17}) {
    std::string text = fmt::format("{:.{}g} {}", value / unit.factor(), digits, unit_text);
    if (parse_quantity(text, unit.dimension) == value) return text;
  }
  return fmt::format("{} {}", format_number(value), unit_name(unit.dimension));
}

}  // namespace rebound
