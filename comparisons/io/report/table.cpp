#include "comparisons/io/report/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lumped/problem/error.hpp"

namespace rebound::report {
namespace {

int decimal_exponent(double value) {
  return value == 0.0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(value))));
}

void require_finite(double value) {
  if (!std::isfinite(value)) {
    throw Error(ExitCode::bad_input, "a number of a report's table is not finite");
  }
}

}  // namespace

TableCell text_cell(const std::string& text, TableCell::Verdict verdict) {
  return {.text = text, .verdict = verdict, .origin = std::nullopt};
}

TableCell number_cell(double value, int significant_digits) {
  require_finite(value);
  if (significant_digits < 1 || significant_digits > 17) {
    throw Error(ExitCode::bad_input, "significant digits of a table cell lie in 1..17");
  }
  // The exponent after rounding: 9.996 has one more digit before its point.
  const std::string scientific = fmt::format("{:.{}e}", value, significant_digits - 1);
  const int exponent = std::stoi(scientific.substr(scientific.find('e') + 1));
  const int decimals = significant_digits - 1 - exponent;
  const bool plain = exponent >= -4 && exponent < std::max(significant_digits, 6);
  const std::string text =
      plain ? fmt::format("{:.{}f}", value, std::max(0, decimals)) : scientific;
  return text_cell(text);
}

TableCell uncertain_cell(double value, double half_width) {
  require_finite(value);
  require_finite(half_width);
  if (half_width <= 0.0) {
    throw Error(ExitCode::bad_input, "the half-width of an uncertain number is positive");
  }
  const int leading = std::max(decimal_exponent(value), decimal_exponent(half_width));
  if (leading >= 6 || leading <= -5) {
    const double scale = std::pow(10.0, leading);
    const int decimals = std::max(0, 1 + leading - decimal_exponent(half_width));
    return text_cell(fmt::format("({:.{}f} ± {:.{}f})e{}", value / scale, decimals,
                                 half_width / scale, decimals, leading));
  }
  const int decimals = std::max(0, 1 - decimal_exponent(half_width));
  return text_cell(fmt::format("{:.{}f} ± {:.{}f}", value, decimals, half_width, decimals));
}

}  // namespace rebound::report
