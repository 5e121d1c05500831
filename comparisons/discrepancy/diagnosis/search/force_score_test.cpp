#include "comparisons/discrepancy/diagnosis/search/force_score_test.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "comparisons/discrepancy/diagnosis/fits/held_out_speed.hpp"
#include "comparisons/discrepancy/diagnosis/search/deflection_loops.hpp"

namespace rebound {
namespace {

using Shots = std::vector<std::size_t>;

/// What all three tests need.
struct LoopsOfFit {
  const Observations& seen;
  const HypothesisFit& fit;
  const EffectSensitivities& around;
  std::vector<DeflectionLoop> loops = deflection_loops(seen, fit);

  Eigen::VectorXd rows_of(const Shots& shots, const ForceOnLoop& force) const {
    return whitened_rows(seen, fit, loops, shots, force);
  }
};

/// One b_j: on one side of the loop, one at the middle and none at its neighbours.
ForceOnLoop hat(bool loading, double middle, double width) {
  return [=](const DeflectionLoop& loop, std::size_t sample) {
    const double x = loop.deflection[sample];
    if (x <= 0.0 || loop.loads_at(sample) != loading) return 0.0;
    return std::max(0.0, 1.0 - std::abs(x - middle) / width);
  };
}

/// Hats over both sides of the deepest loop of some shots.
void add_hats(const LoopsOfFit& of, const Shots& shots, int intervals, ScoredColumns& columns) {
  const double width = deepest_of(of.loops, shots) / intervals;
  for (const bool loading : {true, false})
    for (int k = 0; k <= intervals; ++k)
      columns.add(of.rows_of(shots, hat(loading, k * width, width)));
}

/// One part of a ripple, at its phase where the deflection is none.
ForceOnLoop ripple(bool loading, double cycles, double deepest, double phase) {
  return [=](const DeflectionLoop& loop, std::size_t sample) {
    const double x = loop.deflection[sample] / deepest;
    if (x <= 0.0 || loop.loads_at(sample) != loading) return 0.0;
    return x * std::cos(2.0 * std::numbers::pi * cycles * x - phase);
  };
}

ScoreTest test_ripples(const LoopsOfFit& of, const Shots& shots, double noise_freedom) {
  constexpr double fewest = 2.0, most = 12.0, step = 0.5;
  const double deepest = deepest_of(of.loops, shots);
  std::vector<ScoreTest> outcomes;
  for (const bool loading : {true, false})
    for (double cycles = fewest; cycles <= most; cycles += step) {
      ScoredColumns columns(of.around);
      for (const double phase : {0.0, 0.5 * std::numbers::pi})
        columns.add(of.rows_of(shots, ripple(loading, cycles, deepest, phase)));
      outcomes.push_back(columns.tested_on(of.fit.residuals, noise_freedom));
    }
  return least_likely(outcomes);
}

}  // namespace

ScoreTest test_further_force(const Observations& seen, const HypothesisFit& fit,
                             const EffectSensitivities& around, double noise_freedom) {
  constexpr int intervals_of_all = 16, intervals_of_a_speed = 6;
  if (fit.hypothesis.fem || fit.hypothesis.model_discrepancy) return {};
  const LoopsOfFit of{seen, fit, around};
  Shots every(seen.shots.size());
  std::iota(every.begin(), every.end(), std::size_t{0});
  ScoredColumns of_all(around), of_speeds(around);
  add_hats(of, every, intervals_of_all, of_all);
  for (const SpeedCluster& cluster : speed_clusters(seen))
    add_hats(of, cluster.shots, intervals_of_a_speed, of_speeds);
  return least_likely({of_all.tested_on(fit.residuals, noise_freedom),
                       of_speeds.tested_on(fit.residuals, noise_freedom),
                       test_ripples(of, every, noise_freedom)});
}

}  // namespace rebound
