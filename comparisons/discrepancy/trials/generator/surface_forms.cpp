#include <algorithm>
#include <cmath>
#include <numbers>

#include "comparisons/discrepancy/trials/generator/hidden_effect.hpp"

/// Forms that pull ball and plate together. P = s F_low, F_low the peak force of the baseline at
/// the lowest speed.
namespace trials {
namespace {

/// Everything a pull depends on.
struct PullState {
  double strength;  ///< P [N]
  double u;         ///< x over x_ref; below 0: gap after contact
  double largest;   ///< x_m over x_ref
  bool loading;     ///< x is the largest so far
  const Parameters& more;
};

/// Peak force goes as v^1.2 in the baseline without damping.
double strength_of(double s, const Scales& scales) {
  return s * scales.force * std::pow(scales.smallest_speed / scales.largest_speed, 1.2);
}

double work_of_adhesion(double s, const Scales& scales) {
  return strength_of(s, scales) / (2.0 * std::numbers::pi * scales.radius);
}

EffectForm surface(EffectForm form, double gap_over_x_ref,
                   const std::function<double(const PullState&)>& pull) {
  form.family = "surface";
  form.registry_name = "adhesion";
  form.apply = [=](double s, const Parameters& more, const Scales& scales, HiddenWorld& world) {
    const double x_ref = scales.deflection, strength = strength_of(s, scales);
    world.impact.damping_follows_elastic = false;
    world.impact.rupture_gap = gap_over_x_ref * x_ref;
    world.impact.pull = [=](const Approach& now) {
      return pull({.strength = strength,
                   .u = now.deflection / x_ref,
                   .largest = now.largest / x_ref,
                   .loading = now.deflection >= now.largest,
                   .more = more});
    };
  };
  return form;
}

/// Grows from 0 where unloading begins to 1 at x = 0, and stays.
double unloaded_share(const PullState& now) {
  const double part = std::clamp(now.u / now.largest, 0.0, 1.0);
  return 1.0 - part * part;
}

}  // namespace

std::vector<EffectForm> surface_forms() {
  constexpr double neck = 0.05;
  return {
      surface({.name = "jkr-like",
               .formula = "pull P (u^0.75 + [1 - (x/x_m)^2] on the way back), then a neck that "
                          "tears at 0.05 x_ref beyond the plate",
               .smallest = 0.0003,
               .largest = 0.25},
              neck,
              [](const PullState& now) {
                const double stretched = std::max(0.0, 1.0 + now.u / neck);
                if (now.u <= 0.0) return now.strength * stretched;
                return now.strength * (std::pow(now.u, 0.75) + unloaded_share(now));
              }),
      surface({.name = "dmt",
               .formula = "pull P while in contact, at once",
               .smallest = 0.0003,
               .largest = 0.25,
               .in_registry = true,
               .registry_size = work_of_adhesion},
              0.0, [](const PullState& now) { return now.u > 0.0 ? now.strength : 0.0; }),
      surface({.name = "exponential-cohesive",
               .formula = "on the way back P [1 - (x/x_m)^2] exp(-|x|/x_c), to 0.25 x_ref beyond "
                          "the plate",
               .smallest = 0.0003,
               .largest = 0.25,
               .secondary = {{"x_c_over_x_ref", 0.02, 0.3}}},
              0.25,
              [](const PullState& now) {
                return now.strength * unloaded_share(now) *
                       std::exp(-std::abs(now.u) / now.more.at("x_c_over_x_ref"));
              }),
      surface({.name = "capillary",
               .formula = "pull P (1 - exp(-x_m/h)) in contact, P/(1 + gap/h)^2 beyond, to 0.3 "
                          "x_ref; h the height of the liquid",
               .smallest = 0.0003,
               .largest = 0.25,
               .secondary = {{"h_over_x_ref", 0.01, 0.1}}},
              0.3, [](const PullState& now) {
                const double height = now.more.at("h_over_x_ref");
                const double wetted = now.strength * -std::expm1(-now.largest / height);
                const double gap = std::max(0.0, -now.u) / height;
                return wetted / ((1.0 + gap) * (1.0 + gap));
              })};
}

}  // namespace trials
