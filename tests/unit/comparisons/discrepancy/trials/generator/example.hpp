#pragma once

#include <cmath>

#include "comparisons/discrepancy/trials/generator/baseline_pulse.hpp"
#include "comparisons/discrepancy/trials/generator/hidden_effect.hpp"

/// A ball of 90 g and its impacts, for tests of forms and solver.
namespace trials::testing {

constexpr double speed = 15.0;

inline BaselineBall example_ball(double alpha) {
  return {.mass = 0.09, .stiffness = 3.0e6, .damping = alpha / speed};
}

inline Scales example_scales(double alpha) {
  const BaselinePulse pulse(alpha);
  const PulseScales units = scales_of(example_ball(alpha), speed);
  return {.radius = 0.033,
          .deflection = pulse.peak_deflection() * units.length,
          .force = pulse.peak_force() * units.force,
          .speed = 0.7 * speed,
          .contact_time = pulse.contact_time() * units.time,
          .largest_speed = speed,
          .smallest_speed = speed / 3.0,
          .shots = 2};
}

inline HiddenWorld baseline_world(double alpha) {
  const BaselineBall ball = example_ball(alpha);
  HiddenWorld world;
  world.impact.mass = ball.mass;
  world.impact.stiffness = ball.stiffness;
  world.impact.damping = ball.damping;
  return world;
}

/// The effect at a size, its secondary numbers in the middle of their ranges.
inline HiddenEffect example_effect(const EffectForm& form, double size) {
  HiddenEffect effect{.form = &form, .size = size, .parameters = {}};
  for (const SecondaryRange& range : form.secondary)
    effect.parameters[range.name] =
        range.in_itself ? 0.5 * (range.from + range.to) : std::sqrt(range.from * range.to);
  return effect;
}

inline SimulatedImpact impact_of(const HiddenWorld& world, double alpha) {
  const double expected = example_scales(alpha).contact_time;
  return simulate(world.impact, {.index = 1, .count = 2, .speed = speed},
                  {.expected_contact = expected, .before = expected, .after = expected});
}

inline SimulatedImpact impact_with(const EffectForm& form, double size, double alpha) {
  HiddenWorld world = baseline_world(alpha);
  apply(example_effect(form, size), example_scales(alpha), world);
  return impact_of(world, alpha);
}

/// 200 samples of the record.
inline std::vector<double> record_with(const EffectForm& form, double size, double alpha) {
  const Scales scales = example_scales(alpha);
  HiddenWorld world = baseline_world(alpha);
  apply(example_effect(form, size), scales, world);
  const Sampling sampling{
      .rate = 100.0 / scales.contact_time, .first_time = -0.2 * scales.contact_time, .count = 200};
  std::vector<double> force = reported_force(impact_of(world, alpha), world.chain, sampling, 1);
  digitise(world.chain, force);
  return force;
}

}  // namespace trials::testing
