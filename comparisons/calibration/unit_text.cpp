#include "comparisons/calibration/unit_text.hpp"

#include <fmt/format.h>

namespace rebound {

namespace {

void append(std::string& text, const char* unit, double power) {
  if (power == 0.0) return;
  if (!text.empty()) text += '.';
  text += power == 1.0 ? std::string(unit) : fmt::format("{}^{:.4g}", unit, power);
}

}  // namespace

std::string unit_text(const Dimension& d) {
  std::string text;
  if (d.kilogram != 1.0) {
    append(text, "kg", d.kilogram);
    append(text, "m", d.metre);
    append(text, "s", d.second);
    return text;
  }
  const double metre = d.metre - 1.0, second = d.second + 2.0;  // beside N = kg m/s²
  text = "N";
  append(text, "s", second);
  if (metre > 0.0) append(text, "m", metre);
  if (metre < 0.0) text += metre == -1.0 ? "/m" : fmt::format("/m^{:.4g}", -metre);
  return text;
}

}  // namespace rebound
