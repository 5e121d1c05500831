#include "comparisons/calibration/residual_slopes.hpp"

namespace rebound {

std::vector<Direction> directions_of(const ShotUnknowns& unknowns) {
  std::vector<Direction> by = unknowns.law.by;
  if (unknowns.nuisances.speed_factor) by.push_back({.of = Direction::Of::speed});
  return by;
}

void add_row(const ShotUnknowns& unknowns, const VariedDatum& datum, const RecordErrors& errors,
             std::vector<double>& slopes) {
  slopes.resize(slopes.size() + unknowns.count, 0.0);
  double* const row = slopes.data() + slopes.size() - unknowns.count;
  const double gain = errors.gain / datum.sigma;
  const ShotSlopes& law = unknowns.law;
  for (std::size_t j = 0; j < law.by.size(); ++j)
    row[law.column[j]] += gain * law.weight[j] * datum.slopes[j];
  const NuisancePlaces& at = unknowns.nuisances;
  if (at.gain) row[*at.gain] = datum.force / datum.sigma;
  if (at.trigger) row[*at.trigger] = -gain * datum.rate;
  if (at.baseline) row[*at.baseline] = 1.0 / datum.sigma;
  if (at.speed_factor) row[*at.speed_factor] = gain * datum.speed * datum.slopes.back();
}

}  // namespace rebound
