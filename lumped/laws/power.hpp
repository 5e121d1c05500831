#pragma once

#include <cmath>

namespace rebound {

/// xⁿ for x ≥ 0, with n = 0, ½, 1, … 2½ taken by one square root at most.
///
/// The exponents of contact laws are nearly always halves; std::pow costs
/// about ten times a square root and sits in the innermost loop.
/// Error: within two units in the last place of std::pow
/// -> test PowerTest.HalvesAgreeWithGeneralPower.
class Power {
 public:
  explicit Power(double exponent) : exponent_(exponent) {
    const double halves = 2.0 * exponent;
    if (halves >= 0.0 && halves <= 5.0 && halves == std::floor(halves))
      halves_ = static_cast<int>(halves);
  }

  double exponent() const { return exponent_; }

  double operator()(double x) const {
    switch (halves_) {
      case 0: return 1.0;
      case 1: return std::sqrt(x);
      case 2: return x;
      case 3: return x * std::sqrt(x);
      case 4: return x * x;
      case 5: return x * x * std::sqrt(x);
      default: return std::pow(x, exponent_);
    }
  }

 private:
  double exponent_;
  int halves_ = -1;
};

}  // namespace rebound
