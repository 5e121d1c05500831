#include "comparisons/discrepancy/diagnosis/search/sudden_change.hpp"

#include <algorithm>
#include <span>
#include <vector>

#include "comparisons/discrepancy/diagnosis/fits/held_out_speed.hpp"
#include "comparisons/inference/calibration/whitening.hpp"

namespace rebound {
namespace {

/// The loop of one shot by the fitted model, at the instants of its record.
struct ModelledLoop {
  std::vector<double> force, deflection;
  std::size_t first_row = 0;  ///< of its force among the residuals
};

std::vector<ModelledLoop> modelled_loops(const Observations& seen, const HypothesisFit& fit) {
  std::vector<ModelledLoop> loops(seen.shots.size());
  const auto& rows = fit.model->rows();
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (rows[i].what == ObservedQuantity::force && loops[rows[i].shot].force.empty()) {
      const std::size_t shot = rows[i].shot;
      const std::vector<double>& time = seen.shots[shot].trace.time;
      loops[shot] = {.force = fit.model->force_at(fit.values, shot, time),
                     .deflection = fit.model->deflection_at(fit.values, shot, time),
                     .first_row = i};
    }
  return loops;
}

/// Whitened rows of one loop from where its deflection is first that share of its largest.
void add_from(const ModelledLoop& loop, double share, const ForceNoise& noise,
              Eigen::VectorXd& column) {
  if (loop.force.empty()) return;
  const double deepest = *std::max_element(loop.deflection.begin(), loop.deflection.end());
  const auto from =
      static_cast<std::size_t>(std::find_if(loop.deflection.begin(), loop.deflection.end(),
                                            [&](double x) { return x >= share * deepest; }) -
                               loop.deflection.begin());
  const std::span<double> of_shot(column.data() + loop.first_row, loop.force.size());
  for (std::size_t k = from; k < of_shot.size(); ++k) of_shot[k] = loop.force[k] / noise.deviation;
  take_out_correlation(noise, of_shot);
}

}  // namespace

ScoreTest test_sudden_change(const Observations& seen, const HypothesisFit& fit,
                             const EffectSensitivities& around, double noise_freedom) {
  constexpr int parts = 8;  // of the deflection
  if (fit.hypothesis.fem || fit.hypothesis.model_discrepancy) return {};
  const std::vector<ModelledLoop> loops = modelled_loops(seen, fit);
  ScoredColumns columns(around);
  const std::vector<SpeedCluster> speeds = speed_clusters(seen);
  for (int part = 1; part < parts; ++part) {
    Eigen::VectorXd column = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(fit.residuals.size()));
    for (auto speed = speeds.rbegin(); speed != speeds.rend(); ++speed) {
      for (const std::size_t shot : speed->shots)
        add_from(loops[shot], static_cast<double>(part) / parts, seen.shots[shot].noise, column);
      columns.add(column);
    }
  }
  return columns.largest_on(fit.residuals, noise_freedom);
}

}  // namespace rebound
