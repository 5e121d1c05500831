#include <algorithm>
#include <cmath>
#include <numbers>

#include "comparisons/discrepancy/trials/generator/trial.hpp"

namespace trials {
namespace {

enum Purpose { experiment = 0, shots_of_trial = 1 };

/// Lowest and highest speed, at least a factor of three apart.
std::vector<double> draw_speeds(Random& random) {
  const double lowest = random.log_uniform(2.0, 9.0);
  const double highest = random.log_uniform(3.0 * lowest, 30.0);
  const int count = random.whole(2, 7);
  std::vector<double> speeds;
  for (int i = 0; i < count; ++i) {
    const double inner = i == 0 || i == count - 1 ? 0.0 : random.uniform(-0.3, 0.3);
    const double speed = lowest * std::pow(highest / lowest, (i + inner) / (count - 1));
    speeds.push_back(std::round(100.0 * speed) / 100.0);
  }
  return speeds;
}

/// Contact takes 0.3 to 5 ms at every speed, the ball is no denser than steel and no lighter than
/// foam, and it is pressed in by 0.45 of its radius at most.
bool is_believable(const Trial& trial) {
  const auto contact_time = [&](double speed) {
    return BaselinePulse(trial.ball.damping * speed).contact_time() *
           scales_of(trial.ball, speed).time;
  };
  const double volume = 4.0 / 3.0 * std::numbers::pi * std::pow(trial.radius, 3);
  const double density = trial.ball.mass / volume;
  return density > 100.0 && density < 7800.0 && contact_time(trial.scales.largest_speed) > 0.3e-3 &&
         contact_time(trial.scales.smallest_speed) < 5e-3 &&
         trial.scales.deflection < 0.45 * trial.radius;
}

void draw_ball(Trial& trial, Random& random) {
  Scales& scales = trial.scales;
  scales.speed = std::sqrt(scales.smallest_speed * scales.largest_speed);
  do {
    trial.ball.mass = random.log_uniform(0.02, 0.2);
    trial.radius = random.uniform(0.015, 0.040);
    const double wanted_time = random.log_uniform(0.3e-3, 5e-3);
    trial.restitution_at_mid_speed = random.uniform(0.5, 0.95);
    const double alpha = alpha_of_restitution(trial.restitution_at_mid_speed);
    const BaselinePulse mid(alpha);
    // Contact time is that of the pulse times (m²/(k² v))^(1/5).
    trial.ball.stiffness =
        trial.ball.mass / std::sqrt(scales.speed) * std::pow(mid.contact_time() / wanted_time, 2.5);
    trial.ball.damping = alpha / scales.speed;
    const BaselinePulse fastest(trial.ball.damping * scales.largest_speed);
    const PulseScales units = scales_of(trial.ball, scales.largest_speed);
    scales.contact_time = wanted_time;
    scales.deflection = fastest.peak_deflection() * units.length;
    scales.force = fastest.peak_force() * units.force;
    scales.radius = trial.radius;
  } while (!is_believable(trial));
}

/// True values are what is drawn first; the stated ones lie off by a draw from the uncertainty.
void draw_statements(Trial& trial, Random& random) {
  trial.mass.uncertainty = trial.ball.mass * random.log_uniform(0.0005, 0.005);
  trial.mass.value = trial.ball.mass + trial.mass.uncertainty * random.normal();
  trial.diameter.uncertainty = 2.0 * trial.radius * random.log_uniform(0.0005, 0.005);
  trial.diameter.value = 2.0 * trial.radius + trial.diameter.uncertainty * random.normal();
  trial.gain_uncertainty = random.log_uniform(0.005, 0.03);
  trial.true_gain = 1.0 + trial.gain_uncertainty * random.normal();
  if (random.chance(0.5)) trial.restitution_uncertainty = random.log_uniform(0.003, 0.02);
  trial.believed_stiffness = trial.ball.stiffness * std::pow(1.5, random.uniform(-1.0, 1.0));
  trial.believed_damping =
      trial.ball.stiffness * trial.ball.damping * std::pow(2.0, random.uniform(-1.0, 1.0));
}

void draw_noise_kind(Trial& trial, Random& random) {
  Noise& noise = trial.noise;
  noise.fraction = random.one_of<double>({0.003, 0.01, 0.03, 0.05});
  const BaselinePulse slowest(trial.ball.damping * trial.scales.smallest_speed);
  noise.deviation = noise.fraction * slowest.peak_force() *
                    scales_of(trial.ball, trial.scales.smallest_speed).force;
  const double colour = random.uniform(0.0, 1.0);
  const double correlation = random.one_of<double>({0.3, 0.5, 0.7});
  const double cut_off = random.log_uniform(0.03, 0.2);
  if (colour < 0.5) {
    noise.colour = NoiseColour::white;
  } else if (colour < 0.75) {
    noise.colour = NoiseColour::autoregressive;
    noise.parameter = correlation;
  } else if (colour < 0.875) {
    noise.colour = NoiseColour::band_limited;
    noise.parameter = cut_off;
  } else {
    noise.colour = NoiseColour::one_over_f;
  }
  const double statement = random.uniform(0.0, 1.0);
  if (statement < 0.6) {
    trial.noise_statement = NoiseStatement::right;
    trial.stated_noise = noise.deviation;
  } else if (statement < 0.72) {
    trial.noise_statement = NoiseStatement::half;
    trial.stated_noise = 0.5 * noise.deviation;
  } else if (statement < 0.84) {
    trial.noise_statement = NoiseStatement::twice;
    trial.stated_noise = 2.0 * noise.deviation;
  } else {
    trial.noise_statement = NoiseStatement::absent;
  }
}

void draw_sampling(Trial& trial, Random& random) {
  constexpr double fewest_samples = 60.0;
  const double shortest =
      BaselinePulse(trial.ball.damping * trial.scales.largest_speed).contact_time() *
      scales_of(trial.ball, trial.scales.largest_speed).time;
  std::vector<double> rates;
  for (const double rate : {50e3, 62.5e3, 100e3, 125e3, 200e3})
    if (rate == 200e3 || rate * shortest >= fewest_samples) rates.push_back(rate);
  trial.sampling_rate = random.one_of(rates);
  trial.samples_before = random.whole(60, 150);
  trial.after_share = random.uniform(0.3, 1.0);
}

void draw_shots(Trial& trial, const std::vector<double>& speeds, Random& random) {
  const double relative = random.log_uniform(0.002, 0.02);
  const int most = in_fem(trial.request) ? 1 : 5;
  const int repeats = random.whole(1, most);
  for (const double speed : speeds)
    for (int i = 0; i < repeats; ++i) {
      TrialShot shot;
      shot.speed = {speed, relative * speed};
      shot.true_speed = speed * (1.0 + relative * random.normal());
      shot.sampling_phase = random.uniform(0.0, 1.0);
      trial.shots.push_back(std::move(shot));
    }
  // Half of the laboratories go from slow to fast, half in any order.
  if (random.chance(0.5))
    for (int i = static_cast<int>(trial.shots.size()) - 1; i > 0; --i)
      std::swap(trial.shots[i], trial.shots[random.whole(0, i)]);
  trial.scales.shots = static_cast<int>(trial.shots.size());
}

}  // namespace

std::string name_of(NoiseStatement statement) {
  switch (statement) {
    case NoiseStatement::right: return "right";
    case NoiseStatement::half: return "half";
    case NoiseStatement::twice: return "twice";
    case NoiseStatement::absent: return "absent";
  }
  return "";
}

Trial draw_experiment(const TrialRequest& request) {
  Trial trial;
  trial.request = request;
  Random random({request.seed, request.set, request.number, experiment});
  const bool fem = in_fem(request);
  const std::vector<double> speeds = fem ? draw_fem_speeds(random) : draw_speeds(random);
  trial.scales.smallest_speed = speeds.front();
  trial.scales.largest_speed = speeds.back();
  fem ? draw_fem_ball(trial, random) : draw_ball(trial, random);
  draw_statements(trial, random);
  draw_noise_kind(trial, random);
  draw_sampling(trial, random);
  Random of_shots({request.seed, request.set, request.number, shots_of_trial});
  draw_shots(trial, speeds, of_shots);
  return trial;
}

}  // namespace trials
