#pragma once

#include <algorithm>
#include <cmath>

namespace rebound {

/// So many of so many, with the 95 % interval of the share.
///
///   (p + z²/2n ± z √(p(1 − p)/n + z²/4n²)) / (1 + z²/n),  z = 1.96
///
/// Limit: none of none is anything from 0 to 1 -> test TrialScoreTest.WilsonInterval.
/// Source: Wilson 1927, J. Am. Stat. Assoc. 22, 209.
struct Share {
  int count = 0, of = 0;

  void add(bool yes) {
    ++of;
    if (yes) ++count;
  }
  double value() const { return of == 0 ? 0.0 : static_cast<double>(count) / of; }
  double low() const { return of == 0 ? 0.0 : bound(-1.0); }
  double high() const { return of == 0 ? 1.0 : bound(1.0); }

  double percent() const { return 100.0 * value(); }
  double percent_low() const { return 100.0 * low(); }
  double percent_high() const { return 100.0 * high(); }

 private:
  double bound(double sign) const {
    constexpr double z = 1.96;
    const double n = of, p = value();
    const double root = std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n));
    // Of none and of all the bound is exactly 0 or 1, but for rounding.
    return std::clamp((p + z * z / (2.0 * n) + sign * z * root) / (1.0 + z * z / n), 0.0, 1.0);
  }
};

}  // namespace rebound
