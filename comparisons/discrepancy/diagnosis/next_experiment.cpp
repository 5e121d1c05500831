#include "comparisons/discrepancy/diagnosis/next_experiment.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "comparisons/inference/calibration/distributions.hpp"
#include "comparisons/models/instrument/reported_force.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr int samples = 200;            // of the new force history
constexpr double assumed_noise = 0.01;  // of the peak, where no history tells

/// A shot that was not made, on the ball and with the numbers of an old one.
struct Proposal {
  std::string what;
  std::size_t like = 0;  ///< shot whose ball and numbers are used
  double speed_factor = 1.0;
  double mass_factor = 1.0;
};

std::vector<Proposal> proposals(const Observations& seen) {
  std::size_t slow = 0, fast = 0;
  bool histories = false;
  for (std::size_t i = 0; i < seen.shots.size(); ++i) {
    if (seen.shots[i].impact.speed < seen.shots[slow].impact.speed) slow = i;
    if (seen.shots[i].impact.speed > seen.shots[fast].impact.speed) fast = i;
    histories = histories || seen.shots[i].has_history();
  }
  const auto speed_text = [&](std::size_t i, double factor) {
    return fmt::format("force history at {:.3g} m/s", factor * seen.shots[i].impact.speed);
  };
  std::vector<Proposal> all;
  if (!histories) {
    all.push_back({speed_text(slow, 1.0), slow});
    if (fast != slow) all.push_back({speed_text(fast, 1.0), fast});
  }
  all.push_back({speed_text(slow, 0.3), slow, 0.3});
  all.push_back({speed_text(fast, 1.6), fast, 1.6});
  all.push_back({fmt::format("a ball of twice the mass on the same contact at {:.3g} m/s",
                             seen.shots[fast].impact.speed),
                 fast, 1.0, 2.0});
  return all;
}

Trace predicted(const HypothesisFit& fit, const Proposal& proposal) {
  LumpedProblem problem = fit.model->problem_at(fit.values, proposal.like);
  problem.impact.speed *= proposal.speed_factor;
  problem.sphere.mass *= proposal.mass_factor;
  return simulate_fast(problem).trace;
}

double noise_of(const Observations& seen, const Trace& trace) {
  for (const auto& shot : seen.shots)
    if (shot.has_history()) return shot.noise.deviation;
  return assumed_noise * *std::max_element(trace.force.begin(), trace.force.end());
}

/// Σ [(A − B)/σ]² with gain, clock and baseline of the new shot left free.
double separation(const Observations& seen, const Trace& a, const Trace& b) {
  const double end = 1.2 * std::max(a.time.back(), b.time.back());
  std::vector<double> time;
  time.reserve(samples);
  for (int i = 0; i < samples; ++i) time.push_back(end * (i + 0.5) / samples);
  const auto force_a = reported_force(a, {}, time), force_b = reported_force(b, {}, time);
  const double shift = 1e-3 * end;
  const auto later = reported_force(b, {.trigger_shift = shift}, time);
  Eigen::VectorXd difference(samples);
  Eigen::MatrixXd free(samples, 3);
  for (int i = 0; i < samples; ++i) {
    const auto k = static_cast<std::size_t>(i);
    difference[i] = force_a[k] - force_b[k];
    free.row(i) << force_b[k], (later[k] - force_b[k]) / shift, 1.0;
  }
  const Eigen::VectorXd left = difference - free * free.colPivHouseholderQr().solve(difference);
  const double noise = noise_of(seen, b);
  return left.squaredNorm() / (noise * noise);
}

}  // namespace

std::string label_of(const std::vector<EffectChoice>& effects) {
  std::string label;
  for (const auto& effect : effects) label += (label.empty() ? "" : " + ") + effect.name;
  return label.empty() ? "nothing" : label;
}

std::vector<NextExperiment> next_experiments(const Observations& seen,
                                             const std::vector<const HypothesisFit*>& candidates,
                                             double close_criterion) {
  std::vector<NextExperiment> experiments;
  for (const Proposal& proposal : proposals(seen)) {
    for (std::size_t i = 0; i < candidates.size(); ++i)
      for (std::size_t j = i + 1; j < candidates.size(); ++j) {
        try {
          const double gained = separation(seen, predicted(*candidates[i], proposal),
                                           predicted(*candidates[j], proposal));
          const double lead = (gained - close_criterion) / (2.0 * std::sqrt(gained) + 1e-12);
          experiments.push_back(
              {.what = proposal.what,
               .separates = {label_of(candidates[i]->effects), label_of(candidates[j]->effects)},
               .probability = normal_chance_below(lead)});
        } catch (const Error& error) {
          if (error.code() != ExitCode::solver_failed) throw;  // no such impact: no proposal
        }
      }
  }
  std::stable_sort(experiments.begin(), experiments.end(),
                   [](const NextExperiment& a, const NextExperiment& b) {
                     return a.probability > b.probability;
                   });
  constexpr double worth_it = 0.1;
  std::erase_if(experiments, [](const NextExperiment& e) { return e.probability < worth_it; });
  // One line a pair and one more for an alternative is what a reader uses.
  constexpr std::size_t most = 6;
  if (experiments.size() > most) experiments.resize(most);
  return experiments;
}

}  // namespace rebound
