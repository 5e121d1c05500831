#pragma once

namespace rebound::fem {

/// A plate on its spring and damper that nothing touches any more.
///
///   y(t) = ½ Σ± (y₀ ± s/(ib)) e^{(−a ± ib)t},   s = v₀ + a y₀,
///   a = c/(2M),   b = √(k/M − a²), imaginary where overdamped
///
/// Limit: a critically damped plate is the limit of both -> test MovingPlateTest
struct FreePlate {
  double mass = 0.0, stiffness = 0.0, damping = 0.0;  ///< [kg], [N/m], [N s/m]
  double displacement = 0.0;                          ///< away from the ball [m]
  double velocity = 0.0;                              ///< [m/s]

  double displacement_after(double time) const;
};

/// A body that has left the plate, or only seems to have.
struct Departure {
  double speed = 0.0;      ///< of its centre of mass, away from the plate [m/s]
  double vibration = 0.0;  ///< largest distance its surface may amplitude towards the plate [m]
  double horizon = 0.0;    ///< how far ahead a new contact counts [s]
};

/// Whether a body whose lowest point is at `height` above the plate's place at rest is touched
/// again by the plate's free motion up to the horizon.
bool is_out_of_reach(const FreePlate& plate, double height, const Departure& body);

}  // namespace rebound::fem
