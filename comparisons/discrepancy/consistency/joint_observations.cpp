#include "comparisons/discrepancy/consistency/joint_observations.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rebound {

Observations balls_together(const std::vector<const Observations*>& apart) {
  Observations all;
  for (const Observations* one : apart) {
    const std::size_t before = all.balls.size();
    const bool taken = std::any_of(one->balls.begin(), one->balls.end(), [&](const Ball& ball) {
      return std::any_of(all.balls.begin(), all.balls.end(),
                         [&](const Ball& known) { return known.name == ball.name; });
    });
    const std::string number = taken ? fmt::format(", ball {}", before + 1) : std::string();
    for (const Ball& ball : one->balls) all.balls.emplace_back(ball).name += number;
    for (const MeasuredImpact& shot : one->shots) {
      MeasuredImpact& added = all.shots.emplace_back(shot);
      added.ball += before;
      added.label += number;
      added.number = static_cast<int>(all.shots.size());
    }
    all.gain_uncertainty = std::max(all.gain_uncertainty, one->gain_uncertainty);
    all.noise_freedom = std::max(all.noise_freedom, one->noise_freedom);
    if (all.noise_from.empty()) all.noise_from = one->noise_from;
  }
  return all;
}

}  // namespace rebound
