#pragma once

#include <cmath>

#include "lumped/integration/contact_end.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

/// Sizes of an impact before it is integrated; tolerances are taken of them.
struct ContactScales {
  double deflection = 0.0;  ///< where the elastic energy is ½ m v₀²: the most x can reach [m]
  double time = 0.0;        ///< deflection / v₀; a Hertz contact lasts 3.2 of it [s]
};

/// Solves elastic_energy(x) = ½ m v₀² by Newton in ln E over ln x, where a
/// power law is a straight line and the first step already exact.
///
/// Errors: Error(solver_failed) when the sizes leave the range of numbers.
template <class Law>
requires requires(const Law law, double x) {
  law.elastic_energy(x);
  law.elastic_force(x);
}
ContactScales contact_scales(const Law& law, const ContactSetup& setup) {
  const double energy = 0.5 * setup.mass * setup.speed * setup.speed;
  double x = 1e-3;
  for (int iteration = 0; iteration < 60; ++iteration) {
    const double stored = law.elastic_energy(x);
    const double slope = x * law.elastic_force(x) / stored;  // d ln E / d ln x
    const double step = std::log(energy / stored) / slope;
    x *= std::exp(step);
    if (!std::isnormal(x)) break;
    if (std::abs(step) < 1e-3) return {.deflection = x, .time = x / setup.speed};
  }
  throw Error(ExitCode::solver_failed,
              "the elastic energy of the law does not reach the kinetic energy of the impact");
}

/// Contacts that last longer than this many time scales are given up.
inline constexpr double longest_contact = 2000.0;

inline Error contact_does_not_end() {
  return {ExitCode::solver_failed,
          "the contact does not end: no separation that the tolerance resolves (an overdamped "
          "law never returns to zero deflection)",
          {.key = "impact.separation", .value = "", .allowed = "less damping, or zero-force"}};
}

/// An overdamped ball creeps back to x = 0 until rounding carries it across:
/// a rebound slower than the tolerance resolves is no rebound.
inline void require_rebound(const ContactEnd& end, const ContactSetup& setup) {
  if (!(-end.velocity > 10.0 * setup.relative_tolerance * setup.speed))
    throw contact_does_not_end();
}

}  // namespace rebound
