#pragma once

#include "comparisons/evaluation/convert/codes/other_code.hpp"

/// Codes that combine the material of the ball with that of the wall, which here has the same.
namespace rebound {

inline constexpr double material_poisson_ratio = 0.3;

/// E of both bodies that makes the effective modulus: E* = E/(2 (1 − ν²)).
inline double modulus_of_both(double effective_modulus) {
  return 2.0 * (1.0 - material_poisson_ratio * material_poisson_ratio) * effective_modulus;
}

}  // namespace rebound
