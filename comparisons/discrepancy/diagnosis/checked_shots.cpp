#include "comparisons/discrepancy/diagnosis/checked_shots.hpp"

#include <cmath>

#include "comparisons/models/parallel/in_parallel.hpp"

namespace rebound {
namespace {

Ratio mean_without(const std::vector<Ratio>& ratios, const std::vector<bool>& odd,
                   std::size_t without) {
  double weights = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    if (odd[i] || i == without) continue;
    const double weight = 1.0 / (ratios[i].error * ratios[i].error);
    weights += weight;
    sum += weight * ratios[i].value;
  }
  return weights > 0.0 ? Ratio{sum / weights, 1.0 / std::sqrt(weights)} : Ratio{};
}

}  // namespace

std::vector<CheckedShot> checked_shots(const Observations& seen) {
  std::vector<CheckedShot> shots(seen.shots.size());
  in_parallel(shots.size(), [&](std::size_t i) {
    shots[i].shot = &seen.shots[i];
    if (seen.shots[i].has_history() && seen.shots[i].noise.deviation > 0.0)
      shots[i].readings = read_record(seen.shots[i], 2 * i + 1);
  });
  return shots;
}

double gravity_impulse(const CheckedShot& one) {
  constexpr double gravity = 9.81;
  return one.shot->sphere.mass * gravity * one.reading(RecordNumber::width).value;
}

OddOnes set_odd_ones_apart(const std::vector<Ratio>& ratios) {
  constexpr double apart = 3.0;
  OddOnes found;
  found.odd.assign(ratios.size(), false);
  for (std::size_t left = ratios.size(); left > 2; --left) {
    std::size_t worst = ratios.size();
    double largest = apart;
    for (std::size_t i = 0; i < ratios.size(); ++i) {
      if (found.odd[i]) continue;
      const Ratio rest = mean_without(ratios, found.odd, i);
      const double deviations =
          std::abs(ratios[i].value - rest.value) / std::hypot(ratios[i].error, rest.error);
      if (deviations <= largest) continue;
      largest = deviations;
      worst = i;
    }
    if (worst == ratios.size()) break;
    found.odd[worst] = true;
  }
  found.mean = mean_without(ratios, found.odd, ratios.size());
  for (std::size_t i = 0; i < ratios.size(); ++i)
    found.mean_of_others.push_back(mean_without(ratios, found.odd, i));
  return found;
}

}  // namespace rebound
