#pragma once

namespace rebound {

/// Deflection over R at which a power-law factor is one: x_r = R/10.
inline constexpr double reference_deflection_share = 0.1;
/// Speed at which a power-law factor is one: v_r [m/s].
inline constexpr double reference_speed = 10.0;

}  // namespace rebound
