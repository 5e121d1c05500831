#include "comparisons/discrepancy/diagnosis/search/deflection_loops.hpp"

#include <algorithm>
#include <span>

#include "comparisons/inference/calibration/whitening.hpp"

namespace rebound {

std::vector<DeflectionLoop> deflection_loops(const Observations& seen, const HypothesisFit& fit) {
  std::vector<DeflectionLoop> loops(seen.shots.size());
  const auto& rows = fit.model->rows();
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (!seen.shots[i].has_history()) continue;
    DeflectionLoop& loop = loops[i];
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

double deepest_of(const std::vector<DeflectionLoop>& loops, const std::vector<std::size_t>& shots) {
  double deepest = 0.0;
  for (const std::size_t i : shots)
    if (loops[i].measured()) deepest = std::max(deepest, loops[i].deepest());
  return deepest;
}

Eigen::VectorXd whitened_rows(const Observations& seen, const HypothesisFit& fit,
                              const std::vector<DeflectionLoop>& loops,
                              const std::vector<std::size_t>& shots, const ForceOnLoop& force) {
  Eigen::VectorXd column = Eigen::VectorXd::Zero(std::ssize(fit.residuals));
  for (const std::size_t i : shots) {
    const DeflectionLoop& loop = loops[i];
    if (!loop.measured()) continue;
    const ForceNoise& noise = seen.shots[i].noise;
    const std::span<double> of_shot(column.data() + loop.first_row, loop.deflection.size());
    for (std::size_t k = 0; k < of_shot.size(); ++k) of_shot[k] = force(loop, k) / noise.deviation;
    take_out_correlation(noise, of_shot);
  }
  return column;
}

}  // namespace rebound
