#pragma once

#include <string>

namespace rebound {

/// Physical dimension kg^a m^b s^c. Exponents may be fractions: a contact
/// stiffness F = κ xⁿ has the dimension N/mⁿ.
struct Dimension {
  double kilogram = 0.0;
  double metre = 0.0;
  double second = 0.0;

  friend bool operator==(const Dimension&, const Dimension&) = default;
  friend Dimension operator*(Dimension a, Dimension b) {
    return {a.kilogram + b.kilogram, a.metre + b.metre, a.second + b.second};
  }
  friend Dimension operator/(Dimension a, Dimension b) {
    return {a.kilogram - b.kilogram, a.metre - b.metre, a.second - b.second};
  }
};

/// Equal but for rounding: an exponent may be 1 − 2.2.
bool same_dimension(const Dimension& a, const Dimension& b);

/// The unit a dimension is usually written in: "N/m^1.5", "Pa", "m/s".
std::string unit_name(const Dimension& dimension);

constexpr Dimension power(Dimension d, double n) {
  return {d.kilogram * n, d.metre * n, d.second * n};
}

namespace dimension {
inline constexpr Dimension none{};
inline constexpr Dimension mass{1, 0, 0};
inline constexpr Dimension length{0, 1, 0};
inline constexpr Dimension time{0, 0, 1};
inline constexpr Dimension frequency{0, 0, -1};
inline constexpr Dimension speed{0, 1, -1};
inline constexpr Dimension acceleration{0, 1, -2};
inline constexpr Dimension force{1, 1, -2};
inline constexpr Dimension pressure{1, -1, -2};
inline constexpr Dimension energy_per_area{1, 0, -2};
}  // namespace dimension

}  // namespace rebound
