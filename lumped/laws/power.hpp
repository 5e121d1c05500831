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
  /// Is it Hertz's, x^{3/2}?
  bool hertz() const { return halves_ == 3; }

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

  /// (u²)ⁿ for u = √x ≥ 0: products alone where n is a half.
  double of_root(double u) const {
    switch (halves_) {
      case 0: return 1.0;
      case 1: return u;
      case 2: return u * u;
      case 3: return u * u * u;
      case 4: return (u * u) * (u * u);
      case 5: return (u * u) * (u * u) * u;
      default: return std::pow(u, 2.0 * exponent_);
    }
  }

 private:
  double exponent_;
  int halves_ = -1;
};

/// ln x for x = u² > 0, and 0 at x = 0, where it only ever stands beside a vanishing power.
inline double log_of_root(double u) {
  return u == 0.0 ? 0.0 : 2.0 * std::log(std::abs(u));
}

}  // namespace rebound
