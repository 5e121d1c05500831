#pragma once

#include <vector>

#include "fem/discretisation/discretisation.hpp"
#include "lumped/problem/result.hpp"

namespace rebound::fem {

/// Keeps the body's shape at equally spaced times, the first at rest. Does nothing when
/// no frames are asked for.
class ShapeRecorder {
 public:
  /// `frames` over `expected_duration` [s]; recording goes on at that rate for as long as
  /// the impact lasts.
  ShapeRecorder(const Discretisation& body, int frames, double expected_duration);

  /// `displacement`: (r, z) per node, interleaved [m].
  void record_if_due(double time, const std::vector<double>& displacement);

  const ShapeHistory& history() const { return history_; }

 private:
  const Discretisation& body_;
  double interval_ = 0.0;  ///< zero: off
  double next_ = 0.0;
  ShapeHistory history_;
};

}  // namespace rebound::fem
