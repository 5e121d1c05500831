#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <vector>

namespace trials {

/// State of the contact at one instant.
struct Approach {
  double deflection = 0.0;   ///< x, approach of ball and plate, > 0 in contact [m]
  double rate = 0.0;         ///< ẋ, > 0 while loading [m/s]
  double largest = 0.0;      ///< largest x so far, this one included [m]
  double slip = 0.0;         ///< ζ of Bouc and Wen, between −1 and 1
  double touch_speed = 0.0;  ///< of this shot [m/s]
};

/// Which shot of the trial an impact is.
struct ShotOrder {
  int index = 0;
  int count = 1;
  double speed = 0.0;  ///< true approach speed at the start of the record [m/s]
};

/// Maxwell branch: q = share (F_e − u), u' = (F_e − u)/time.
struct MaxwellBranch {
  double share = 0.0;
  double time = 0.0;  ///< [s]
  /// Above 0: the spring is linear and F_e is this stiffness times x [N/m].
  double linear_stiffness = 0.0;
};

/// A mass on a spring and a damper.
struct Oscillator {
  double mass = 0.0;       ///< [kg]
  double stiffness = 0.0;  ///< [N/m]
  double damping = 0.0;    ///< [N s/m]
};

/// Another ball that follows the first.
struct SecondBall {
  double mass = 0.0;
  double delay = 0.0;      ///< how much later it would be at the plate [s]
  double stiffness = 0.0;  ///< [N/m^1.5]
};

/// A pull on the ball that acts at a distance: strength exp(−gap/range).
struct DistantPull {
  double strength = 0.0;  ///< [N]
  double range = 0.0;     ///< [m]
};

/// A ball on a plate. As it stands: Hunt–Crossley,
///
///   F = k x^1.5 (1 + λ ẋ),   m ẍ = −F.
///
/// Effects replace the functions. The force is never below zero unless something pulls.
struct ImpactModel {
  double mass = 0.0;       ///< m [kg]
  double stiffness = 0.0;  ///< k [N/m^1.5]
  double damping = 0.0;    ///< λ [s/m]

  /// Does the damping grow with the changed elastic force, or with that of the baseline?
  bool damping_follows_elastic = true;
  /// Elastic force, from x and the baseline's k x^1.5.
  std::function<double(double x, double hertz)> elastic;
  /// Damping force, from the state and the baseline's.
  std::function<double(const Approach&, double baseline)> dissipation;
  /// Elastic force under a history, from the state and the virgin curve.
  std::function<double(const Approach&, const std::function<double(double)>& virgin)> history;
  /// Pull towards the plate, from the state [N].
  std::function<double(const Approach&)> pull;
  double rupture_gap = 0.0;  ///< distance at which the pull ends [m]
  double slip_length = 0.0;  ///< of Bouc and Wen; 0: not used [m]
  /// Factors on k for one shot; they multiply.
  std::vector<std::function<double(const ShotOrder&)>> stiffness_factors;

  std::vector<MaxwellBranch> branches;
  std::optional<Oscillator> plate;  ///< the load cell reads its spring and damper
  std::optional<Oscillator> frame;  ///< carries the plate
  std::optional<Oscillator> inner;  ///< part of the ball's mass, on a spring inside it
  std::optional<SecondBall> second_ball;
  std::optional<DistantPull> distant_pull;
};

/// k x^1.5 of the baseline; 0 without contact.
inline double hertz_force(double stiffness, double x) {
  return x > 0.0 ? stiffness * x * std::sqrt(x) : 0.0;
}

}  // namespace trials
