#include "comparisons/discrepancy/diagnosis/search/varying_numbers.hpp"

#include <algorithm>
#include <functional>

#include "comparisons/discrepancy/diagnosis/fits/held_out_speed.hpp"

namespace rebound {
namespace {

using Weight = std::function<double(std::size_t shot)>;

/// The Jacobian by one unknown, in each shot times its weight.
Eigen::VectorXd weighted_column(const HypothesisFit& fit, const Eigen::VectorXd& column,
                                std::size_t shots, const Weight& weight) {
  Eigen::VectorXd weighted = Eigen::VectorXd::Zero(column.size());
  const auto& rows = fit.model->rows();
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (rows[k].shot < shots)
      weighted[static_cast<Eigen::Index>(k)] =
          weight(rows[k].shot) * column[static_cast<Eigen::Index>(k)];
  return weighted;
}

}  // namespace

ScoreTest test_varying_numbers(const Observations& seen, const HypothesisFit& fit,
                               const EffectSensitivities& around, double noise_freedom) {
  if (fit.hypothesis.fem || fit.hypothesis.model_discrepancy) return {};
  const std::size_t shots = seen.shots.size();
  const auto tested_with = [&](const std::vector<Weight>& weights) {
    ScoredColumns columns(around);
    for (std::size_t ball = 0; ball < seen.balls.size(); ++ball)
      for (const std::size_t unknown : fit.model->unknowns_of_ball(ball))
        for (const Weight& weight : weights)
          columns.add(weighted_column(
              fit, around.jacobian().col(static_cast<Eigen::Index>(unknown)), shots, weight));
    return columns.tested_on(fit.residuals, noise_freedom);
  };
  std::vector<Weight> of_speeds, of_shots;
  for (const SpeedCluster& cluster : speed_clusters(seen))
    of_speeds.push_back([members = cluster.shots](std::size_t shot) {
      return std::count(members.begin(), members.end(), shot) > 0 ? 1.0 : 0.0;
    });
  for (std::size_t one = 0; one < shots; ++one)
    of_shots.push_back([one](std::size_t shot) { return shot == one ? 1.0 : 0.0; });
  return least_likely({tested_with(of_speeds), tested_with(of_shots)});
}

}  // namespace rebound
