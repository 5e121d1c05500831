#include "comparisons/studies/reproduce/row.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/io/toml/units.hpp"

namespace rebound {

const char* name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::reproduces: return "reproduces";
    case Verdict::within_rounding: return "within-rounding";
    case Verdict::differs: return "differs";
  }
  return "";
}

Verdict judge(const PrintedNumber& published, double computed, const Interval& range) {
  // Decimal halves are not binary: an edge is met within a few units of the last place.
  const double slack = 1e-12 * std::abs(published.value);
  const Interval printed{published.value - published.half_width - slack,
                         published.value + published.half_width + slack};
  if (overlap(printed, {computed, computed})) return Verdict::reproduces;
  return overlap(printed, range) ? Verdict::within_rounding : Verdict::differs;
}

std::vector<PrintedNumber> printed_inputs(const DerivedRow& row) {
  std::vector<PrintedNumber> inputs;
  for (const Input& input : row.inputs) inputs.push_back(input.printed);
  return inputs;
}

Row evaluate(const DerivedRow& row) {
  std::vector<double> nominal;
  for (const Input& input : row.inputs) nominal.push_back(input.printed.value);
  Row result{.key = row.key, .published = row.published};
  result.computed = row.formula(nominal);
  result.range = corner_range(row.formula, printed_inputs(row));
  result.verdict = judge(row.published, result.computed, result.range);
  return result;
}

double unit_size(const RowKey& key) {
  if (key.unit == "1" || key.unit == "%") return 1.0;
  if (key.unit == "km/h") return 1.0 / 3.6;  // no unit of configuration files
  // "1e5 N/m" is a unit with a factor, as tables print it in their heading.
  const auto space = key.unit.find(' ');
  const double factor = space == std::string::npos ? 1.0 : std::stod(key.unit.substr(0, space));
  return factor *
         parse_unit(space == std::string::npos ? key.unit : key.unit.substr(space + 1)).factor();
}

std::string as_printed(const Row& row, double value, int further_digits) {
  const double size = unit_size(row.key);
  int decimals = 3;
  if (row.published.half_width > 0.0)
    decimals = static_cast<int>(std::lround(-std::log10(2.0 * row.published.half_width / size)));
  return fmt::format("{:.{}f}", value / size, std::max(0, decimals + further_digits));
}

std::string scope_of(const std::string& core, double speed) {
  if (core.empty()) return speed > 0.0 ? fmt::format("{:g} m/s", speed) : "all";
  return speed > 0.0 ? fmt::format("core {} at {:g} m/s", core, speed) : "core " + core;
}

}  // namespace rebound
