#include <cmath>

#include "comparisons/discrepancy/trials/generator/hidden_effect.hpp"

/// Forms whose missing force depends on the deflection and its rate now.
/// D = k λ x^1.5 ẋ is the damping force of the baseline.
namespace trials {
namespace {

using Dissipation =
    std::function<double(double s, const Scales&, const Approach&, double baseline)>;

/// A form that changes D alone.
EffectForm by_damping(EffectForm form, const Dissipation& changed) {
  form.family = "rate";
  form.apply = [changed](double s, const Parameters&, const Scales& scales, HiddenWorld& world) {
    world.impact.dissipation = [=](const Approach& now, double baseline) {
      return changed(s, scales, now, baseline);
    };
  };
  return form;
}

/// D mixed with a damping that grows with another power of x and equals D at 0.6 x_ref.
Dissipation other_power(double power) {
  return [power](double s, const Scales& scales, const Approach& now, double baseline) {
    const double u = now.deflection / (0.6 * scales.deflection);
    return baseline * (1.0 - s + s * std::pow(u, power - 1.5));
  };
}

double dashpot(double s, const Scales& scales) {
  return s * scales.force / scales.largest_speed;
}

EffectForm by_stiffness(
    EffectForm form, const std::function<double(double s, const Scales&, double speed)>& factor) {
  form.family = "rate";
  form.apply = [factor](double s, const Parameters&, const Scales& scales, HiddenWorld& world) {
    world.impact.damping_follows_elastic = false;
    world.impact.stiffness_factors.push_back(
        [=](const ShotOrder& shot) { return factor(s, scales, shot.speed); });
  };
  return form;
}

std::vector<EffectForm> stiffness_forms() {
  return {by_stiffness({.name = "rate-stiffening-power",
                        .formula = "F_e (v0/(10 m/s))^s",
                        .smallest = 0.0005,
                        .largest = 0.2,
                        .registry_name = "rate-stiffening",
                        .in_registry = true},
                       [](double s, const Scales&, double v) { return std::pow(v / 10.0, s); }),
          by_stiffness({.name = "rate-stiffening-log",
                        .formula = "F_e (1 + s ln(v0/v_mid))",
                        .smallest = 0.0005,
                        .largest = 0.2,
                        .registry_name = "rate-stiffening"},
                       [](double s, const Scales& scales, double v) {
                         return 1.0 + s * std::log(v / scales.speed);
                       })};
}

}  // namespace

std::vector<EffectForm> rate_forms() {
  std::vector<EffectForm> forms = {
      by_damping({.name = "kuwabara-kono",
                  .formula = "(1 - s) D + s C sqrt(x) x', equal at 0.6 x_ref",
                  .smallest = 0.003,
                  .largest = 1.0,
                  .registry_name = "damping-exponent",
                  .in_registry = true,
                  .only_at_largest = true,
                  .registry_size = [](double, const Scales&) { return -1.0; }},
                 other_power(0.5)),
      by_damping({.name = "tsuji",
                  .formula = "(1 - s) D + s C x^(1/4) x', equal at 0.6 x_ref",
                  .smallest = 0.003,
                  .largest = 1.0,
                  .registry_name = "damping-exponent",
                  .in_registry = true,
                  .only_at_largest = true,
                  .registry_size = [](double, const Scales&) { return -1.25; }},
                 other_power(0.25)),
      by_damping({.name = "linear-dashpot",
                  .formula = "D + c x', c = s F_ref/v_max",
                  .smallest = 0.0005,
                  .largest = 0.3,
                  .registry_name = "linear-dashpot",
                  .in_registry = true,
                  .registry_size = dashpot},
                 [](double s, const Scales& scales, const Approach& now, double baseline) {
                   return baseline + dashpot(s, scales) * now.rate;
                 }),
      by_damping({.name = "velocity-power",
                  .formula = "D |x'/(10 m/s)|^s",
                  .smallest = 0.003,
                  .largest = 0.9,
                  .either_sign = true,
                  .registry_name = "velocity-exponent",
                  .in_registry = true},
                 [](double s, const Scales&, const Approach& now, double baseline) {
                   const double rate = std::abs(now.rate);
                   return rate > 0.0 ? baseline * std::pow(rate / 10.0, s) : 0.0;
                 }),
      by_damping({.name = "quadratic-velocity",
                  .formula = "D (1 + s |x'|/v_mid)",
                  .smallest = 0.003,
                  .largest = 1.5,
                  .registry_name = "velocity-exponent"},
                 [](double s, const Scales& scales, const Approach& now, double baseline) {
                   return baseline * (1.0 + s * std::abs(now.rate) / scales.speed);
                 })};
  for (EffectForm& form : stiffness_forms()) forms.push_back(std::move(form));
  return forms;
}

}  // namespace trials
