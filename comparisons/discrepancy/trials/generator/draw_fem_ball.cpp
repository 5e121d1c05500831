#include <cmath>
#include <numbers>

#include "comparisons/discrepancy/trials/generator/fem_materials.hpp"
#include "comparisons/discrepancy/trials/generator/trial.hpp"

namespace trials {

std::vector<double> draw_fem_speeds(Random& random) {
  const double highest = random.uniform(12.0, 28.0);
  const double lowest = highest / random.uniform(3.0, 5.0);
  std::vector<double> speeds = {lowest, std::sqrt(lowest * highest), highest};
  for (double& speed : speeds) speed = std::round(100.0 * speed) / 100.0;
  return speeds;
}

/// Stiffness and scales are those of Hertz: what is scaled by them needs no exact numbers.
void draw_fem_ball(Trial& trial, Random& random) {
  Scales& scales = trial.scales;
  scales.speed = std::sqrt(scales.smallest_speed * scales.largest_speed);
  trial.ball.mass = random.uniform(0.04, 0.12);
  trial.radius = random.uniform(0.022, 0.036);
  const FemBall& kind = random.one_of(fem_materials());
  const double density =
      trial.ball.mass / (4.0 / 3.0 * std::numbers::pi * std::pow(trial.radius, 3));
  const double modulus = density * std::pow(scales.largest_speed / random.uniform(0.06, 0.16), 2);
  const double nu = kind.poisson_ratio;
  trial.ball.stiffness = 4.0 / 3.0 * modulus / (1.0 - nu * nu) * std::sqrt(trial.radius);
  trial.restitution_at_mid_speed = random.uniform(0.6, 0.95);
  trial.ball.damping = alpha_of_restitution(trial.restitution_at_mid_speed) / scales.speed;
  const BaselinePulse mid(trial.ball.damping * scales.speed),
      fastest(trial.ball.damping * scales.largest_speed);
  scales.contact_time = mid.contact_time() * scales_of(trial.ball, scales.speed).time;
  const PulseScales units = scales_of(trial.ball, scales.largest_speed);
  scales.deflection = fastest.peak_deflection() * units.length;
  scales.force = fastest.peak_force() * units.force;
  scales.radius = trial.radius;
  trial.fem = draw_material(modulus, scales.contact_time, kind, random);
}

}  // namespace trials
