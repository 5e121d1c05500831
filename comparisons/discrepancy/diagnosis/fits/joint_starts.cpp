// Where records start, beyond what slopes tell: the fourth part of JointModel.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "comparisons/discrepancy/diagnosis/fits/joint_model.hpp"
#include "comparisons/models/instrument/sample_step.hpp"

namespace rebound {
namespace {

/// The first of two readings in a row that are beyond the noise, before the largest; the first of
/// all where there are none.
std::size_t onset_of(const MeasuredImpact& shot) {
  constexpr double beyond_noise = 5.0;  // standard deviations
  const std::vector<double>& force = shot.trace.force;
  const double level = beyond_noise * shot.noise.deviation;
  const auto is_beyond = [&](std::size_t i) {
    return std::abs(force[i] - shot.noise.zero) > level;
  };
  const auto peak =
      static_cast<std::size_t>(std::max_element(force.begin(), force.end()) - force.begin());
  for (std::size_t i = 0; i + 1 <= peak; ++i)
    if (is_beyond(i) && is_beyond(i + 1)) return i;
  return 0;
}

}  // namespace

std::vector<double> JointModel::with_settled_starts(std::vector<double> values) const {
  constexpr double farthest = 3.0, coarse = 0.25, fine = 0.05;  // samples
  if (fem()) return values;
  for (const auto& [shot, place] : starts_) {
    const double sample = mean_sample_step(seen_.shots[shot].trace.time);
    const auto left = [&, shot = shot] {
      const std::vector<double> block = block_at(values, shot);
      return std::inner_product(block.begin(), block.end(), block.begin(), 0.0);
    };
    double least = left();
    const auto look_around = [&, place = place](double reach, double step) {
      const double middle = values[place];
      double best = middle;
      for (double moved = -reach; moved < reach + 0.5 * step; moved += step) {
        values[place] =
            std::clamp(middle + moved * sample, unknowns_[place].lowest, unknowns_[place].highest);
        if (const double now = left(); now < least) {
          least = now;
          best = values[place];
        }
      }
      values[place] = best;
    };
    look_around(farthest, coarse);
    look_around(coarse, fine);
  }
  return values;
}

std::vector<double> JointModel::with_starts_at_jumps(std::vector<double> values) const {
  constexpr double just_after = 0.1, before_onset = 0.3;  // samples
  constexpr double seen = 2.0;                            // standard deviations of the noise
  if (fem()) return values;
  for (const auto& [shot, place] : starts_) {
    const MeasuredImpact& measured = seen_.shots[shot];
    const double sample = mean_sample_step(measured.trace.time), start = values[place];
    const std::vector<double> force =
        force_at(values, shot, {start - just_after * sample, start + just_after * sample});
    if (std::abs(force[1] - force[0]) < seen * measured.noise.deviation) continue;
    const std::size_t onset = onset_of(measured);
    if (onset == 0) continue;
    values[place] = std::clamp(measured.trace.time[onset] - before_onset * sample,
                               unknowns_[place].lowest, unknowns_[place].highest);
  }
  return values;
}

}  // namespace rebound
