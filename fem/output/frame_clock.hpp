#pragma once

namespace rebound::fem {

/// Equally spaced instants from zero on; never, when no frames are asked for.
class FrameClock {
 public:
  /// `frames` over `duration` [s], and on at that rate.
  FrameClock(int frames, double duration) : interval_(frames > 0 ? duration / frames : 0.0) {}

  bool is_due(double time) const { return interval_ > 0.0 && time >= next_; }
  void tick() { next_ += interval_; }

 private:
  double interval_;  ///< zero: never
  double next_ = 0.0;
};

}  // namespace rebound::fem
