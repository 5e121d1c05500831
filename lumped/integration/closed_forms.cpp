#include "lumped/integration/closed_forms.hpp"

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/special_functions/log1p.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "lumped/problem/error.hpp"

namespace rebound {

namespace {

/// sin(√a t)/√a with a of either sign: the response of an oscillator whose
/// squared damped frequency is a.
double oscillation(double squared, double t) {
  const double root = std::sqrt(std::abs(squared));
  if (root * t < 1e-6) return t * (1.0 - squared * t * t / 6.0);
  return squared > 0.0 ? std::sin(root * t) / root : std::sinh(root * t) / root;
}

double oscillation_rate(double squared, double t) {
  const double root = std::sqrt(std::abs(squared));
  return squared > 0.0 ? std::cos(root * t) : std::cosh(root * t);
}

}  // namespace

KelvinVoigtImpact::KelvinVoigtImpact(const LinearKelvinVoigt& law, const Approach& approach)
    : law_(law),
      approach_(approach),
      frequency_(std::sqrt(law.stiffness / approach.mass)),
      zeta_(0.5 * law.damping / std::sqrt(law.stiffness * approach.mass)) {}

ContactState KelvinVoigtImpact::at(double time) const {
  const double squared = frequency_ * frequency_ * (1.0 - zeta_) * (1.0 + zeta_);
  const double rate = zeta_ * frequency_;
  const double decay = approach_.speed * std::exp(-rate * time);
  const double s = oscillation(squared, time);
  const double x = decay * s;
  const double v = decay * (oscillation_rate(squared, time) - rate * s);
  return {x, v, law_.force(x, v)};
}

double KelvinVoigtImpact::contact_time(SeparationRule rule) const {
  if (rule == SeparationRule::zero_force) return 2.0 * kelvin_voigt_half_phase(zeta_) / frequency_;
  kelvin_voigt_restitution(zeta_, rule);  // refuses the overdamped case
  return std::numbers::pi / (frequency_ * std::sqrt((1.0 - zeta_) * (1.0 + zeta_)));
}

ElasticImpact elastic_impact(const HuntCrossley& law, const Approach& approach) {
  const double n = law.power.exponent();
  const double q = 1.0 / (n + 1.0);
  const double energy = 0.5 * approach.mass * approach.speed * approach.speed;
  ElasticImpact impact;
  impact.peak_deflection = std::pow((n + 1.0) * energy / law.stiffness, q);
  impact.peak_force = law.elastic_force(impact.peak_deflection);
  impact.contact_time = 2.0 * q * std::sqrt(std::numbers::pi) *
                        boost::math::tgamma_delta_ratio(q, 0.5) * impact.peak_deflection /
                        approach.speed;
  return impact;
}

HuntCrossleyImpact::HuntCrossleyImpact(const HuntCrossley& law, const Approach& approach)
    : law_(law), approach_(approach), p_(law.damping * approach.speed / law.stiffness) {
  if (!(p_ >= 1e-6) || p_ > 1e6)
    throw Error(ExitCode::bad_input, "damping number outside the closed form's range",
                {.key = "damping", .value = std::to_string(p_), .allowed = "[1e-6, 1e6]"});
  restitution_ = hunt_crossley_restitution(p_);
}

namespace {

/// −[ln(1 + z) − z] + z r, the deflection measure near either end of the
/// impact, written so that it keeps its digits as z → 0.
double measure(double z, double r) {
  const double gap = std::abs(z) < 0.5 ? boost::math::log1pmx(z) : std::log1p(z) - z;
  return gap + z * r;
}

}  // namespace

double HuntCrossleyImpact::loading_deflection(double lost_speed) const {
  const double d = p_ * lost_speed / approach_.speed;  // p − w
  // [p − ln(1+p)] − [w − ln(1+w)] with z = −d/(1+p)
  const double bracket = measure(-d / (1.0 + p_), 0.0) + d * p_ / (1.0 + p_);
  const double n1 = law_.power.exponent() + 1.0;
  const double scale = approach_.mass * n1 * law_.stiffness / (law_.damping * law_.damping);
  return std::pow(scale * bracket, 1.0 / n1);
}

double HuntCrossleyImpact::unloading_deflection(double speed_to_gain) const {
  const double d = p_ * speed_to_gain / approach_.speed;  // w + p e
  const double pe = p_ * restitution_;
  const double bracket = measure(d / (1.0 - pe), pe);
  const double n1 = law_.power.exponent() + 1.0;
  const double scale = approach_.mass * n1 * law_.stiffness / (law_.damping * law_.damping);
  return std::pow(scale * bracket, 1.0 / n1);
}

double HuntCrossleyImpact::deflection(double velocity) const {
  return velocity >= 0.0 ? loading_deflection(approach_.speed - velocity)
                         : unloading_deflection(velocity + restitution_ * approach_.speed);
}

double HuntCrossleyImpact::time_to_peak() const {
  boost::math::quadrature::tanh_sinh<double> quadrature;
  return quadrature.integrate(
      [&](double lost) {
        const double v = approach_.speed - lost;
        return approach_.mass / law_.force(loading_deflection(lost), v);
      },
      0.0, approach_.speed);
}

double HuntCrossleyImpact::contact_time() const {
  boost::math::quadrature::tanh_sinh<double> quadrature;
  const double rebound_speed = restitution_ * approach_.speed;
  return time_to_peak() +
         quadrature.integrate(
             [&](double to_gain) {
               const double v = to_gain - rebound_speed;
               return approach_.mass / law_.force(unloading_deflection(to_gain), v);
             },
             0.0, rebound_speed);
}

double HuntCrossleyImpact::peak_force() const {
  const auto negative_force = [&](double v) { return -law_.force(deflection(v), v); };
  const auto lowest = boost::math::tools::brent_find_minima(negative_force, 0.0, approach_.speed,
                                                            std::numeric_limits<double>::digits);
  return -lowest.second;
}

}  // namespace rebound
