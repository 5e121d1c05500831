#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/trials/generator/trial.hpp"

namespace trials {
namespace {

constexpr int noise_purpose = 3;

HiddenWorld world_of(const Trial& trial, const std::vector<HiddenEffect>& effects) {
  HiddenWorld world;
  world.impact.mass = trial.ball.mass;
  world.impact.stiffness = trial.ball.stiffness;
  world.impact.damping = trial.ball.damping;
  world.fem = trial.fem;
  world.chain.gain = trial.true_gain;
  for (const HiddenEffect& effect : effects) apply(effect, trial.scales, world);
  return world;
}

/// Times of the record of a shot; touch falls between two samples anywhere.
Sampling sampling_of(const Trial& trial, const TrialShot& shot, double contact_time) {
  constexpr double fewest_after = 40.0;
  const double rate = trial.sampling_rate;
  const double after = std::max(fewest_after, trial.after_share * contact_time * rate);
  return {
      .rate = rate,
      .first_time = -(trial.samples_before + shot.sampling_phase) / rate,
      .count = trial.samples_before + 1 + static_cast<int>(std::ceil(contact_time * rate + after))};
}

void record_shot(const Trial& trial, const NoiseFree& free, std::size_t i, TrialShot& shot) {
  const TrialRequest& request = trial.request;
  const SimulatedImpact& impact = free.impacts[i];
  Random random({request.seed, request.set, request.number, noise_purpose + static_cast<int>(i)});
  shot.true_restitution = impact.restitution;
  shot.true_contact_time = impact.contact_time;
  shot.true_peak_force = impact.peak_force;
  if (trial.restitution_uncertainty) {
    const double u = *trial.restitution_uncertainty;
    shot.restitution = {std::clamp(impact.restitution + u * random.normal(), 0.0, 1.0), u};
  }
  shot.force = recorded(free, i, free.samplings[i]);
  const std::vector<double> noise =
      draw_noise(trial.noise, static_cast<int>(shot.force.size()), random);
  for (std::size_t k = 0; k < noise.size(); ++k) {
    shot.force[k] += noise[k];
    shot.time.push_back(static_cast<double>(k) / trial.sampling_rate);
  }
  digitise(free.world.chain, shot.force);
}

}  // namespace

std::vector<double> recorded(const NoiseFree& free, std::size_t shot, const Sampling& sampling) {
  return reported_force(free.impacts[shot], free.world.chain, sampling, static_cast<int>(shot));
}

NoiseFree simulate_in_fem(const Trial& trial, const std::vector<HiddenEffect>& effects, int cells) {
  NoiseFree free{.world = world_of(trial, effects), .impacts = {}, .samplings = {}};
  for (const TrialShot& shot : trial.shots) {
    free.impacts.push_back(trial.request.fem->impact(free.world.fem, {.mass = trial.ball.mass,
                                                                      .radius = trial.radius,
                                                                      .speed = shot.true_speed,
                                                                      .cells = cells}));
    free.samplings.push_back(sampling_of(trial, shot, free.impacts.back().contact_time));
  }
  return free;
}

NoiseFree simulate_trial(const Trial& trial, const std::vector<HiddenEffect>& effects) {
  if (in_fem(trial.request)) return simulate_in_fem(trial, effects, cells_of_visibility);
  NoiseFree free{.world = world_of(trial, effects), .impacts = {}, .samplings = {}};
  int index = 0;
  for (const TrialShot& shot : trial.shots) {
    const double expected = BaselinePulse(trial.ball.damping * shot.true_speed).contact_time() *
                            scales_of(trial.ball, shot.true_speed).time;
    const double margin = 3.0 / trial.sampling_rate + 0.5 * expected;
    free.impacts.push_back(
        simulate(free.world.impact,
                 {.index = index++, .count = trial.scales.shots, .speed = shot.true_speed},
                 {.expected_contact = expected,
                  .before = trial.samples_before / trial.sampling_rate + margin,
                  .after = std::max(41.0 / trial.sampling_rate, 1.2 * expected) + margin}));
    free.samplings.push_back(sampling_of(trial, shot, free.impacts.back().contact_time));
  }
  return free;
}

namespace {

RefitProblem refit_problem(const Trial& trial, const NoiseFree& free,
                           const std::vector<Sampling>& samplings) {
  RefitProblem problem{.ball = trial.ball,
                       .gain = trial.true_gain,
                       .gain_uncertainty = std::hypot(trial.gain_uncertainty,
                                                      trial.mass.uncertainty / trial.ball.mass),
                       .noise = trial.noise,
                       .shots = {}};
  for (std::size_t i = 0; i < trial.shots.size(); ++i) {
    RefitShot shot;
    shot.force = recorded(free, i, samplings[i]);
    digitise(free.world.chain, shot.force);
    for (std::size_t k = 0; k < shot.force.size(); ++k)
      shot.time.push_back(samplings[i].first_time + static_cast<double>(k) / trial.sampling_rate);
    shot.speed = trial.shots[i].true_speed;
    shot.speed_uncertainty = trial.shots[i].speed.uncertainty;
    shot.restitution = free.impacts[i].restitution;
    shot.restitution_uncertainty = trial.restitution_uncertainty;
    problem.shots.push_back(std::move(shot));
  }
  return problem;
}

}  // namespace

Refit what_shows(const Trial& trial, const std::vector<HiddenEffect>& effects,
                 const std::vector<Sampling>& samplings) {
  return refit_baseline(refit_problem(trial, simulate_trial(trial, effects), samplings));
}

double visible_chi_square(const Trial& trial, const std::vector<HiddenEffect>& effects) {
  if (in_fem(trial.request)) return visible_chi_square_in_fem(trial, effects);
  const NoiseFree free = simulate_trial(trial, effects);
  RefitProblem problem = refit_problem(trial, free, free.samplings);
  // A second start, for an effect may have a nearer minimum in the way.
  const double from_truth = refit_baseline(problem).chi_square;
  problem.ball.stiffness *= 1.3;
  problem.ball.damping *= 0.5;
  return std::min(from_truth, refit_baseline(problem).chi_square);
}

Trial make_trial(const TrialRequest& request) {
  Trial trial = draw_experiment(request);
  draw_effects(trial);
  trial.visible_chi_square = visible_chi_square(trial, trial.effects);
  if (in_fem(request))
    trial.visible_chi_square =
        std::min(trial.visible_chi_square, least_chi_square_in_fem(trial, trial.effects));
  if (!in_fem(request)) trial.rivals = rivals_of(trial);  // of forms that do not run in FE
  const NoiseFree free = in_fem(request) ? simulate_in_fem(trial, trial.effects, cells_of_data)
                                         : simulate_trial(trial, trial.effects);
  for (std::size_t i = 0; i < trial.shots.size(); ++i) record_shot(trial, free, i, trial.shots[i]);
  return trial;
}

}  // namespace trials
