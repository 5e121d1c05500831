#pragma once

#include <concepts>
#include <cstddef>
#include <string>

#include "lumped/laws/law_card.hpp"
#include "lumped/problem/impact.hpp"

namespace rebound {

/// What a law may use to turn a restitution into its damping.
struct DampingRequest {
  std::string formula;         ///< name, e.g. "exact"
  double restitution = 1.0;    ///< to be returned, in (0, 1] [-]
  double mass = 0.0;           ///< [kg]
  Impact impact;               ///< approach speed and separation rule
  ParameterValues parameters;  ///< all parameters but the damping, SI
};

/// A force with what integrators need of its slopes, at one point of the motion.
struct ForceSlopes {
  double force = 0.0;              ///< F [N]
  double damping = 0.0;            ///< F_d [N]
  double by_log_deflection = 0.0;  ///< x ∂F/∂x: finite at first touch, where ∂F/∂x is not [N]
  double by_speed = 0.0;           ///< ∂F/∂ẋ [N s/m]
};

/// A contact law: a small callable struct, F = F_e(x) + F_d(x, ẋ).
///
///   x   deflection, towards the plate positive  [m]
///   ẋ   closing speed, approaching positive     [m/s]
///   F   force on the ball, compression positive [N]
///
/// Needed of every law (one test battery runs over all of them):
///   F_e(0) = 0, elastic_energy(x) = ∫₀ˣ F_e dx [J], F_d ẋ ≥ 0.
/// Continuation to x < 0, where integrators evaluate while they locate the
/// separation: F_e odd in x, F_d taken at |x|. With it the total force of an
/// opening contact changes its sign once.
///
/// `at_root(u, ẋ)` is the same force once more as the fast integrator asks for it, by u = √x
/// (x = u|u|), where half-integer powers are products; with its slopes. `slope_by(i, u, ẋ)`
/// is ∂F/∂pᵢ, parameters in the order of the card. The battery holds both against
/// `force` -> tests LawBattery.RootFormIsTheForce, SlopesAreThoseOfTheForce.
///
/// A law with a state of its own has `RelaxationBranch branch() const`, see
/// standard_linear_solid.hpp.
/// A law whose card names a damping parameter also has
/// `static double damping_for(const DampingRequest&)`. A law that takes a value
/// from the sphere has `static void complete(ParameterValues&, const Sphere&)`.
template <class Law>
concept ContactLaw = requires(const Law law, double x, double v, const ParameterValues& values) {
  { Law::card() } -> std::same_as<LawCard>;
  { Law::from(values) } -> std::same_as<Law>;
  { law.elastic_force(x) } -> std::same_as<double>;
  { law.damping_force(x, v) } -> std::same_as<double>;
  { law.force(x, v) } -> std::same_as<double>;
  { law.elastic_energy(x) } -> std::same_as<double>;
  { law.at_root(x, v) } -> std::same_as<ForceSlopes>;
  { law.slope_by(std::size_t{}, x, v) } -> std::same_as<double>;
};

}  // namespace rebound
