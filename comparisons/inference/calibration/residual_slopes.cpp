#include "comparisons/inference/calibration/residual_slopes.hpp"

namespace rebound {

std::vector<Direction> directions_of(const ShotUnknowns& unknowns) {
  std::vector<Direction> by = unknowns.law.by;
  for (const NuisancePlace& place : unknowns.nuisances)
    if (place.kind->moves != Direction::Of::nothing) by.push_back({.of = place.kind->moves});
  return by;
}

void add_row(const ShotUnknowns& unknowns, const DatumWithSensitivities& datum,
             const MeasurementChain& chain, std::vector<double>& slopes) {
  slopes.resize(slopes.size() + unknowns.count, 0.0);
  double* const row = slopes.data() + slopes.size() - unknowns.count;
  const double gain = (1.0 + chain.force_gain) / datum.sigma;
  const ShotSlopes& law = unknowns.law;
  for (std::size_t j = 0; j < law.by.size(); ++j)
    row[law.column[j]] += gain * law.weight[j] * datum.slopes[j];
  std::size_t next = law.by.size();
  for (const auto& [kind, unknown, is_factor] : unknowns.nuisances) {
    const double moved = kind->moves == Direction::Of::nothing ? 0.0 : datum.slopes[next++];
    row[unknown] = kind->slope(datum, moved, chain);
    if (is_factor) row[unknown] *= kind->asked.slope_of(chain.*kind->error);
  }
}

}  // namespace rebound
