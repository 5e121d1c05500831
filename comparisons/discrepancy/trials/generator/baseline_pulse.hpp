#pragma once

#include <vector>

namespace trials {

/// A ball that obeys Hunt–Crossley, F = k x^1.5 (1 + λ ẋ).
struct BaselineBall {
  double mass = 0.0;       ///< m [kg]
  double stiffness = 0.0;  ///< k [N/m^1.5]
  double damping = 0.0;    ///< λ [s/m]
};

/// The baseline without dimensions:
///
///   ξ'' = −ξ^1.5 (1 + α ξ'),  ξ(0) = 0, ξ'(0) = 1
///
///   X = (m v²/k)^(2/5), x = X ξ, t = (X/v) τ, F = (m v²/X) f(τ), α = λ v
///
/// One number, α, makes all its shapes.
class BaselinePulse {
 public:
  explicit BaselinePulse(double alpha);

  double force(double tau) const;  ///< f, cubic between the steps
  double slope(double tau) const;  ///< df/dτ
  double contact_time() const { return end_; }
  double restitution() const { return restitution_; }
  double peak_force() const { return peak_force_; }
  double peak_deflection() const { return peak_deflection_; }

 private:
  std::vector<double> force_, slope_;
  double end_ = 0.0, restitution_ = 0.0, peak_force_ = 0.0, peak_deflection_ = 0.0;
};

/// X, X/v and m v²/X.
struct PulseScales {
  double length, time, force;
};
PulseScales scales_of(const BaselineBall& ball, double speed);

/// α of a restitution, from p (1 + e) = ln[(1 + p)/(1 − p e)] by bisection.
double alpha_of_restitution(double restitution);

}  // namespace trials
