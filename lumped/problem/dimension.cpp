#include "lumped/problem/dimension.hpp"

#include <cmath>
#include <cstdio>

namespace rebound {
namespace {

/// Exponents as a person writes them, free of the rounding of 1 − 2.2.
std::string factor_text(const std::string& symbol, double exponent) {
  if (exponent == 1.0) return symbol;
  char text[32];
  std::snprintf(text, sizeof text, "^%.10g", exponent);
  return symbol + text;
}

}  // namespace

bool same_dimension(const Dimension& a, const Dimension& b) {
  constexpr double tolerance = 1e-9;
  return std::abs(a.kilogram - b.kilogram) < tolerance && std::abs(a.metre - b.metre) < tolerance &&
         std::abs(a.second - b.second) < tolerance;
}

std::string unit_name(const Dimension& d) {
  if (same_dimension(d, dimension::none)) return "";
  if (same_dimension(d, dimension::pressure)) return "Pa";
  if (same_dimension(d, dimension::frequency)) return "Hz";
  if (same_dimension(d, dimension::length / dimension::force)) return "m/N";
  // A contact law's numbers are forces over powers of deflection and speed.
  const bool force = std::abs(d.kilogram - 1.0) < 1e-9 && d.second < -0.5;
  const Dimension rest = force ? d / dimension::force : d;
  std::string product = force ? "N" : "";
  std::string quotient;
  const auto add = [&](const char* symbol, double exponent) {
    if (std::abs(exponent) < 1e-9) return;
    if (exponent > 0.0)
      product += (product.empty() ? "" : ".") + factor_text(symbol, exponent);
    else
      quotient += "/" + factor_text(symbol, -exponent);
  };
  if (!force) add("kg", rest.kilogram);
  add("m", rest.metre);
  add("s", rest.second);
  return (product.empty() ? "1" : product) + quotient;
}

}  // namespace rebound
