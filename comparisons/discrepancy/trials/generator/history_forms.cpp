#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/trials/generator/hidden_effect.hpp"

/// Forms whose missing force depends on the largest deflection so far, not on its rate.
/// E(x) is the elastic force of first loading, x_m the largest deflection so far.
namespace trials {
namespace {

using Virgin = std::function<double(double)>;
using Unloading =
    std::function<double(double s, const Parameters&, double x, double largest, const Virgin&)>;

EffectForm history(EffectForm form, const Unloading& unloading) {
  form.family = "history";
  form.apply = [unloading](double s, const Parameters& parameters, const Scales&,
                           HiddenWorld& world) {
    world.impact.damping_follows_elastic = false;
    world.impact.history = [=](const Approach& now, const Virgin& virgin) {
      return unloading(s, parameters, now.deflection, now.largest, virgin);
    };
  };
  return form;
}

/// Loading as Hertz to x_y, then a straight line; unloading as a flatter sphere, from x_p on.
EffectForm thornton() {
  return {.family = "history",
          .name = "thornton",
          .formula =
              "yield at x_y = (1 - s) x_ref, then its tangent; unloading k_p (x - x_p)^1.5, "
              "k_p = k sqrt(H(x_m)/F_m)",
          .smallest = 0.005,
          .largest = 0.85,
          .registry_name = "permanent-set",
          .apply = [](double s, const Parameters&, const Scales& scales, HiddenWorld& world) {
            const double yield = (1.0 - s) * scales.deflection, k = world.impact.stiffness;
            world.impact.damping_follows_elastic = false;
            world.impact.history = [=](const Approach& now, const Virgin& virgin) {
              if (now.largest <= yield) return virgin(now.deflection);
              const double slope = 1.5 * virgin(yield) / yield;
              const double top = virgin(yield) + slope * (now.largest - yield);
              if (now.deflection >= now.largest) return top;
              const double flat = k * std::sqrt(hertz_force(k, now.largest) / top);
              const double rest = now.largest - std::pow(top / flat, 2.0 / 3.0);
              return hertz_force(flat, now.deflection - rest);
            };
          }};
}

EffectForm bouc_wen() {
  return {.family = "history",
          .name = "bouc-wen",
          .formula = "E (1 + s z), z' = (x' - z |x'|)/x_c",
          .smallest = 0.0005,
          .largest = 0.3,
          .secondary = {{"x_c_over_x_ref", 0.05, 0.4}},
          .registry_name = "hysteresis",
          .apply = [](double s, const Parameters& parameters, const Scales& scales,
                      HiddenWorld& world) {
            world.impact.damping_follows_elastic = false;
            world.impact.slip_length = parameters.at("x_c_over_x_ref") * scales.deflection;
            world.impact.history = [=](const Approach& now, const Virgin& virgin) {
              return virgin(now.deflection) * (1.0 + s * now.slip);
            };
          }};
}

}  // namespace

std::vector<EffectForm> history_forms() {
  return {
      history({.name = "walton-braun",
               .formula = "unloading E(x_m) - (1 + s) (E(x_m) - E(x)), not below 0",
               .smallest = 0.001,
               .largest = 1.5,
               .registry_name = "permanent-set"},
              [](double s, const Parameters&, double x, double largest, const Virgin& virgin) {
                const double top = virgin(largest);
                return std::max(0.0, top - (1.0 + s) * (top - virgin(x)));
              }),
      thornton(),
      history({.name = "mullins-exponential",
               .formula = "unloading E [1 - s (1 - exp(-b (1 - x/x_m)))/(1 - exp(-b))]",
               .smallest = 0.001,
               .largest = 0.6,
               .secondary = {{"b", 1.0, 8.0}},
               .registry_name = "hysteresis"},
              [](double s, const Parameters& p, double x, double largest, const Virgin& virgin) {
                const double b = p.at("b");
                const double share = std::expm1(-b * (1.0 - x / largest)) / std::expm1(-b);
                return virgin(x) * (1.0 - s * share);
              }),
      history({.name = "linear-hysteresis",
               .formula = "unloading E [1 - s (1 - x/x_m)]",
               .smallest = 0.001,
               .largest = 0.6,
               .registry_name = "hysteresis",
               .in_registry = true},
              [](double s, const Parameters&, double x, double largest, const Virgin& virgin) {
                return virgin(x) * (1.0 - s * (1.0 - x / largest));
              }),
      bouc_wen(),
      history({.name = "permanent-set",
               .formula = "unloading E(x_m) ((x - s x_m)/((1 - s) x_m))^1.5",
               .smallest = 0.0005,
               .largest = 0.3,
               .registry_name = "permanent-set",
               .in_registry = true},
              [](double s, const Parameters&, double x, double largest, const Virgin& virgin) {
                const double part = (x - s * largest) / ((1.0 - s) * largest);
                return part > 0.0 ? virgin(largest) * std::pow(part, 1.5) : 0.0;
              })};
}

}  // namespace trials
