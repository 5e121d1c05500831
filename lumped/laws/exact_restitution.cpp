#include "lumped/laws/exact_restitution.hpp"

#include <boost/math/special_functions/log1p.hpp>
#include <boost/math/tools/roots.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

#include "lumped/problem/error.hpp"
#include "lumped/problem/lumped_problem.hpp"

namespace rebound {

namespace {

namespace tools = boost::math::tools;

void require_restitution(double e) {
  require_in_range(limit_of<&LumpedModel::restitution>.range, e, {"model"}, "restitution");
}

/// s − (1 − e^{−s}), free of cancellation: −[ln(1−y) + y] with y = 1 − e^{−s}.
/// Writing the unloading branch in s instead of y = p e keeps all digits when
/// y runs into 1, where a heavily damped contact ends.
double unloading_measure(double s) {
  if (s > 0.5) return s + std::expm1(-s);
  return -boost::math::log1pmx(std::expm1(-s));
}

/// p − ln(1 + p), the same measure of the loading branch.
double loading_measure(double p) {
  return p < 0.5 ? -boost::math::log1pmx(p) : p - std::log1p(p);
}

}  // namespace

double hunt_crossley_restitution(double p) {
  if (!(p >= 0.0) || std::isinf(p))
    throw Error(ExitCode::bad_input, "the damping number must be finite and not negative",
                {.key = "damping", .value = std::to_string(p), .allowed = ">= 0"});
  if (p < 1e-9) return 1.0 - 2.0 / 3.0 * p;  // the next term, (4/9) p², is below rounding
  const double target = loading_measure(p);
  // √(2A) and A + 1 bracket the root of s − 1 + e^{−s} = A.
  const auto residual = [&](double s) { return unloading_measure(s) - target; };
  std::uintmax_t iterations = 200;
  const auto bracket =
      tools::toms748_solve(residual, std::sqrt(2.0 * target) * (1.0 - 1e-14), target + 1.0,
                           tools::eps_tolerance<double>(52), iterations);
  return -std::expm1(-0.5 * (bracket.first + bracket.second)) / p;
}

double hunt_crossley_damping_number(double e) {
  require_restitution(e);
  if (e == 1.0) return 0.0;
  const auto number = [&](double s) { return -std::expm1(-s) / e; };
  const auto residual = [&](double s) { return unloading_measure(s) - loading_measure(number(s)); };
  // Small-loss root of the two leading terms as the first guess; the residual
  // is negative below the root and positive above it.
  const double guess = 1.5 * (1.0 - e) * (1.0 + e) * e / (1.0 + e * e * e);
  std::uintmax_t iterations = 200;
  const auto bracket = tools::bracket_and_solve_root(residual, guess, 2.0, true,
                                                     tools::eps_tolerance<double>(52), iterations);
  return number(0.5 * (bracket.first + bracket.second));
}

double kelvin_voigt_half_phase(double zeta) {
  const double y = 1.0 - zeta;
  if (std::abs(y) < 1e-4)  // θ/sin θ with θ = acos ζ, expanded in 1 − ζ
    return 1.0 + y * (1.0 / 3.0 + y * (2.0 / 15.0 + y * (2.0 / 35.0)));
  if (zeta < 1.0) return std::acos(zeta) / std::sqrt((1.0 - zeta) * (1.0 + zeta));
  return std::acosh(zeta) / std::sqrt((zeta - 1.0) * (zeta + 1.0));
}

double kelvin_voigt_restitution(double zeta, SeparationRule rule) {
  if (!(zeta >= 0.0))
    throw Error(ExitCode::bad_input, "the damping ratio must not be negative",
                {.key = "damping", .value = std::to_string(zeta), .allowed = ">= 0"});
  if (rule == SeparationRule::zero_force)
    return std::exp(-2.0 * zeta * kelvin_voigt_half_phase(zeta));
  if (zeta >= 1.0)
    throw Error(ExitCode::solver_failed,
                "the contact does not end: overdamped Kelvin-Voigt never returns to zero "
                "deflection",
                {.key = "damping", .value = std::to_string(zeta), .allowed = "damping ratio < 1"});
  return std::exp(-std::numbers::pi * zeta / std::sqrt((1.0 - zeta) * (1.0 + zeta)));
}

double kelvin_voigt_damping_ratio(double e, SeparationRule rule) {
  require_restitution(e);
  if (e == 1.0) return 0.0;
  const double loss = -std::log(e);
  if (rule == SeparationRule::zero_deflection) return loss / std::hypot(std::numbers::pi, loss);
  const auto residual = [&](double zeta) {
    return 2.0 * zeta * kelvin_voigt_half_phase(zeta) - loss;
  };
  std::uintmax_t iterations = 200;
  const auto bracket = tools::bracket_and_solve_root(residual, loss / std::numbers::pi, 2.0, true,
                                                     tools::eps_tolerance<double>(52), iterations);
  return 0.5 * (bracket.first + bracket.second);
}

}  // namespace rebound
