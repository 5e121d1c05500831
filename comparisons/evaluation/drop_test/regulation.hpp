#pragma once

#include <cmath>

namespace rebound {

/// What the regulation asks of a sliotar.
///
/// Source: Hanley et al., sliotar core impact, section 1: restitution between
///         0.522 and 0.576 from a drop height of 1.8 m.
struct Regulation {
  double drop_height = 1.8;  ///< [m]
  double lowest = 0.522;     ///< restitution [-]
  double highest = 0.576;
};

/// Speed after a free fall, v = √(2 g h), g = 9.80665 m/s². Drag is left out:
/// over 1.8 m it takes about 2 % of a sliotar's energy, 1 % of its speed.
inline double drop_speed(double height) {
  return std::sqrt(2.0 * 9.80665 * height);
}

}  // namespace rebound
