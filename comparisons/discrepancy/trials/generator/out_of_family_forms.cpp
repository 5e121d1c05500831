#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/trials/generator/hidden_effect.hpp"

/// Truths that no family of the diagnosis describes.
namespace trials {
namespace {

EffectForm stick_slip() {
  return {.family = "out_of_family",
          .name = "force-jumps",
          .formula =
              "while loading E (1 + s (frac(x/d) - 1/2)): builds up and slips at fixed "
              "deflections",
          .smallest = 0.002,
          .largest = 0.5,
          .secondary = {{"d_over_x_ref", 0.1, 0.4}},
          .apply = [](double s, const Parameters& more, const Scales& scales, HiddenWorld& world) {
            const double spacing = more.at("d_over_x_ref") * scales.deflection;
            world.impact.damping_follows_elastic = false;
            world.impact.history = [=](const Approach& now,
                                       const std::function<double(double)>& virgin) {
              const double part = now.deflection / spacing;
              const double saw = part - std::floor(part) - 0.5;
              return virgin(now.deflection) * (now.rate > 0.0 ? 1.0 + s * saw : 1.0);
            };
          }};
}

EffectForm fracture() {
  return {.family = "out_of_family",
          .name = "fracture",
          .formula = "above the speed v_c: E (1 - s) for good once x has reached 0.5 x_ref v/v_max",
          .smallest = 0.002,
          .largest = 0.6,
          .secondary = {{"v_c_share", 0.2, 0.8, true}},
          .apply = [](double s, const Parameters& more, const Scales& scales, HiddenWorld& world) {
            const double critical =
                scales.smallest_speed +
                more.at("v_c_share") * (scales.largest_speed - scales.smallest_speed);
            world.impact.damping_follows_elastic = false;
            world.impact.history = [=](const Approach& now,
                                       const std::function<double(double)>& virgin) {
              const double at = 0.5 * scales.deflection * now.touch_speed / scales.largest_speed;
              const bool broken = now.touch_speed > critical && now.largest > at;
              return virgin(now.deflection) * (broken ? 1.0 - s : 1.0);
            };
          }};
}

EffectForm ageing() {
  return {.family = "out_of_family",
          .name = "ageing",
          .formula = "stiffness (1 + s i/(n - 1)) k in shot i of n: the ball warms up or hardens",
          .smallest = 0.001,
          .largest = 0.4,
          .either_sign = true,
          .apply = [](double s, const Parameters&, const Scales&, HiddenWorld& world) {
            world.impact.stiffness_factors.push_back([s](const ShotOrder& shot) {
              return 1.0 + s * shot.index / std::max(1, shot.count - 1);
            });
          }};
}

EffectForm second_ball() {
  return {.family = "out_of_family",
          .name = "second-ball",
          .formula = "a ball of s times the mass follows and hits the first from behind",
          .smallest = 0.001,
          .largest = 0.5,
          .secondary = {{"delay_over_T", 0.1, 0.4}},
          .apply = [](double s, const Parameters& more, const Scales& scales, HiddenWorld& world) {
            world.impact.second_ball = {.mass = s * world.impact.mass,
                                        .delay = more.at("delay_over_T") * scales.contact_time,
                                        .stiffness = world.impact.stiffness};
          }};
}

EffectForm magnet() {
  return {.family = "out_of_family",
          .name = "magnet",
          .formula = "pull s F_ref exp(-gap/L) between ball and plate, also out of contact",
          .smallest = 0.0001,
          .largest = 0.15,
          .secondary = {{"L_over_x_ref", 0.5, 5.0}},
          .apply = [](double s, const Parameters& more, const Scales& scales, HiddenWorld& world) {
            world.impact.distant_pull = {.strength = s * scales.force,
                                         .range = more.at("L_over_x_ref") * scales.deflection};
          }};
}

}  // namespace

std::vector<EffectForm> out_of_family_forms() {
  return {stick_slip(), fracture(), ageing(), second_ball(), magnet()};
}

}  // namespace trials
