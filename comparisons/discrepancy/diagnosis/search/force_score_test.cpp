#include "comparisons/discrepancy/diagnosis/search/force_score_test.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "comparisons/discrepancy/diagnosis/fits/held_out_speed.hpp"
#include "comparisons/inference/calibration/whitening.hpp"

namespace rebound {
namespace {

/// The loop of one shot by the fitted model, at the instants of its record.
struct Loop {
  std::vector<double> deflection;
  std::size_t top = 0;        ///< sample of the largest deflection
  std::size_t first_row = 0;  ///< of its force among the residuals

  bool measured() const { return !deflection.empty(); }
  double deepest() const { return deflection[top]; }
};

std::vector<Loop> loops_of(const Observations& seen, const HypothesisFit& fit) {
  std::vector<Loop> loops(seen.shots.size());
  const auto& rows = fit.model->rows();
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (!seen.shots[i].has_history()) continue;
    Loop& loop = loops[i];
    loop.deflection = fit.model->deflection_at(fit.values, i, seen.shots[i].trace.time);
    const auto top = std::max_element(loop.deflection.begin(), loop.deflection.end());
    loop.top = static_cast<std::size_t>(top - loop.deflection.begin());
    const auto first = std::find_if(rows.begin(), rows.end(), [&](const DataRow& row) {
      return row.shot == i && row.what == ObservedQuantity::force;
    });
    loop.first_row = static_cast<std::size_t>(first - rows.begin());
  }
  return loops;
}

/// One b_j: on one side of the loop, one at the middle and none at its neighbours.
struct Hat {
  bool loading = true;
  double middle = 0.0, width = 0.0;

  double at(const Loop& loop, std::size_t sample) const {
    const double x = loop.deflection[sample];
    if (x <= 0.0 || (sample <= loop.top) != loading) return 0.0;
    return std::max(0.0, 1.0 - std::abs(x - middle) / width);
  }
};

/// Hats over both sides of a loop of that depth.
std::vector<Hat> hats_over(double deepest, int intervals) {
  std::vector<Hat> hats;
  const double width = deepest / intervals;
  for (const bool loading : {true, false})
    for (int k = 0; k <= intervals; ++k)
      hats.push_back({.loading = loading, .middle = k * width, .width = width});
  return hats;
}

/// Whitened rows of a unit force that is added in some shots.
Eigen::VectorXd whitened_rows(const Observations& seen, const std::vector<Loop>& loops,
                              const std::vector<std::size_t>& shots, const Hat& hat,
                              Eigen::Index rows) {
  Eigen::VectorXd column = Eigen::VectorXd::Zero(rows);
  for (const std::size_t i : shots) {
    const Loop& loop = loops[i];
    if (!loop.measured()) continue;
    const ForceNoise& noise = seen.shots[i].noise;
    const std::span<double> of_shot(column.data() + loop.first_row, loop.deflection.size());
    for (std::size_t k = 0; k < of_shot.size(); ++k) of_shot[k] = hat.at(loop, k) / noise.deviation;
    take_out_correlation(noise, of_shot);
  }
  return column;
}

double deepest_of(const std::vector<Loop>& loops, const std::vector<std::size_t>& shots) {
  double deepest = 0.0;
  for (const std::size_t i : shots)
    if (loops[i].measured()) deepest = std::max(deepest, loops[i].deepest());
  return deepest;
}

}  // namespace

ScoreTest test_further_force(const Observations& seen, const HypothesisFit& fit,
                             const EffectSensitivities& around, double noise_freedom) {
  constexpr int intervals_of_all = 16, intervals_of_a_speed = 6;
  if (fit.hypothesis.fem || fit.hypothesis.model_discrepancy) return {};
  const std::vector<Loop> loops = loops_of(seen, fit);
  const auto rows = static_cast<Eigen::Index>(fit.residuals.size());
  ScoredColumns of_all(around), of_speeds(around);
  std::vector<std::size_t> every(seen.shots.size());
  std::iota(every.begin(), every.end(), std::size_t{0});
  for (const Hat& hat : hats_over(deepest_of(loops, every), intervals_of_all))
    of_all.add(whitened_rows(seen, loops, every, hat, rows));
  for (const SpeedCluster& cluster : speed_clusters(seen))
    for (const Hat& hat : hats_over(deepest_of(loops, cluster.shots), intervals_of_a_speed))
      of_speeds.add(whitened_rows(seen, loops, cluster.shots, hat, rows));
  return least_likely({of_all.tested_on(fit.residuals, noise_freedom),
                       of_speeds.tested_on(fit.residuals, noise_freedom)});
}

}  // namespace rebound
