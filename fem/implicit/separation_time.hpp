#pragma once

#include <cmath>

namespace rebound::fem {

/// When the plate stopped pushing, between two steps.
///
///   F ∝ (T − t)^{3/2} as the last of the contact goes:  T from the last two forces
///
/// at most a step after the last force that was not zero.
class SeparationTime {
 public:
  struct Step {
    double from = 0.0, to = 0.0;  ///< [s]
  };
  /// Force of the plate at the end of a step [N].
  void add(double force, const Step& step) {
    if (force > 0.0) {
      found_ = step.to;
    } else if (last_ > 0.0) {
      const double last = std::cbrt(last_ * last_);
      const double fall = std::cbrt(before_ * before_) - last;
      found_ = step.from + (step.to - step.from) * (fall > last ? last / fall : 1.0);
    }
    before_ = last_;
    last_ = force;
  }

  double found() const { return found_; }      ///< zero before any contact [s]
  double last_force() const { return last_; }  ///< [N]

 private:
  double found_ = 0.0, last_ = 0.0, before_ = 0.0;
};

}  // namespace rebound::fem
