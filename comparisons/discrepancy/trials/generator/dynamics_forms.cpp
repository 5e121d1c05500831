#include <cmath>
#include <numbers>

#include "comparisons/discrepancy/trials/generator/hidden_effect.hpp"

/// Forms in which another mass moves: the support or part of the ball.
namespace trials {
namespace {

Oscillator oscillator(double mass, double stiffness, double damping_ratio) {
  return {.mass = mass,
          .stiffness = stiffness,
          .damping = 2.0 * damping_ratio * std::sqrt(stiffness * mass)};
}

/// A stiffer plate rings beyond what a recorder follows, and its filter takes that away.
constexpr double smallest_compliance = 2e-4;

double compliance(double s, const Scales& scales) {
  return s * scales.deflection / scales.force;
}

Oscillator plate(double s, const Parameters& p, const Scales& scales, double ball_mass) {
  return oscillator(p.at("mass_over_ball") * ball_mass, 1.0 / compliance(s, scales),
                    p.at("damping_ratio"));
}

}  // namespace

std::vector<EffectForm> dynamics_forms() {
  return {{.family = "dynamics",
           .name = "plate-on-spring",
           .formula = "M y'' + c y' + K y = F, 1/K = s x_ref/F_ref; the cell reads K y + c y'",
           .smallest = smallest_compliance,
           .largest = 0.25,
           .secondary = {{"mass_over_ball", 3.0, 40.0}, {"damping_ratio", 0.005, 0.1}},
           .registry_name = "plate-compliance",
           .in_registry = true,
           .apply =
               [](double s, const Parameters& p, const Scales& scales, HiddenWorld& world) {
                 world.impact.plate = plate(s, p, scales, world.impact.mass);
               },
           .registry_size = compliance},
          {.family = "dynamics",
           .name = "two-mass-ball",
           .formula = "share s of the mass inside on a spring; the law sees the outer mass",
           .smallest = 0.001,
           .largest = 0.4,
           .secondary = {{"frequency_times_T", 0.7, 6.0}, {"damping_ratio", 0.01, 0.1}},
           .registry_name = "internal-mode",
           .apply =
               [](double s, const Parameters& p, const Scales& scales, HiddenWorld& world) {
                 // The frequency is that of the free ball: both masses move.
                 const double w =
                     2.0 * std::numbers::pi * p.at("frequency_times_T") / scales.contact_time;
                 const double mass = s * world.impact.mass, reduced = mass * (1.0 - s);
                 world.impact.inner = oscillator(mass, reduced * w * w, p.at("damping_ratio"));
               }},
          {.family = "dynamics",
           .name = "plate-on-frame",
           .formula = "as plate-on-spring, on a frame with a spring and damper of its own",
           .smallest = smallest_compliance,
           .largest = 0.25,
           .secondary = {{"mass_over_ball", 3.0, 20.0},
                         {"damping_ratio", 0.005, 0.1},
                         {"frame_mass_over_plate", 0.5, 5.0},
                         {"frame_stiffness_over_plate", 0.5, 4.0}},
           .registry_name = "plate-compliance",
           .apply = [](double s, const Parameters& p, const Scales& scales, HiddenWorld& world) {
             world.impact.plate = plate(s, p, scales, world.impact.mass);
             world.impact.frame =
                 oscillator(world.impact.plate->mass * p.at("frame_mass_over_plate"),
                            world.impact.plate->stiffness * p.at("frame_stiffness_over_plate"),
                            p.at("damping_ratio"));
           }}};
}

}  // namespace trials
