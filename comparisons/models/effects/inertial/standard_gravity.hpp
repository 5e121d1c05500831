#pragma once

namespace rebound {

/// Standard acceleration of free fall, CGPM 1901 [m/s²].
inline constexpr double standard_gravity = 9.80665;

}  // namespace rebound
