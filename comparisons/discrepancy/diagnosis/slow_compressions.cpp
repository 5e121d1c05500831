#include "comparisons/discrepancy/diagnosis/slow_compressions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "comparisons/io/dataset/contact_window.hpp"

namespace rebound {
namespace {

constexpr double assumed_force_share = 0.05;

/// Deflection of one contact that the impacts of a data set reached; infinite without histories.
double reach_of_impacts(const Dataset& dataset) {
  constexpr double hertz_duration = 2.94;  // T v / x_max
  double reach = 0.0;
  for (const MeasuredImpact& shot : dataset.shots) {
    if (!shot.has_history()) continue;
    const double peak = *std::max_element(shot.trace.force.begin(), shot.trace.force.end());
    if (!(peak > 0.0)) continue;
    const SampleRange contact = contact_window(shot.trace.force, clearly_in_contact * peak);
    const double duration = shot.trace.time[contact.last] - shot.trace.time[contact.first];
    reach = std::max(reach, 1.2 * shot.impact.speed * duration / hertz_duration);
  }
  return reach > 0.0 ? reach : std::numeric_limits<double>::infinity();
}

/// Means of a curve's way in over stretches of deflection.
void add_points(const ForceDeflectionCurve& curve, double reach, double share,
                SlowCompression& test) {
  constexpr double from = 0.2;
  constexpr int stretches = 8;
  const auto top = std::max_element(curve.deflection.begin(), curve.deflection.end());
  const auto way_in = static_cast<std::size_t>(top - curve.deflection.begin()) + 1;
  const double last = std::min(*top, reach);
  for (int k = 0; k < stretches; ++k) {
    const auto edge = [&](int i) { return last * (from + (1.0 - from) * i / stretches); };
    double deflection = 0.0, force = 0.0, count = 0.0;
    for (std::size_t i = 0; i < way_in; ++i) {
      if (curve.deflection[i] < edge(k) || curve.deflection[i] > edge(k + 1)) continue;
      deflection += curve.deflection[i];
      force += curve.force[i];
      count += 1.0;
    }
    if (count == 0.0 || !(force > 0.0)) continue;
    test.deflection.push_back(deflection / count);
    test.force.push_back(force / count);
    test.error.push_back(share * force / count);
  }
}

void add_compression(const Dataset& dataset, std::size_t number, std::size_t ball,
                     Observations& seen) {
  const Quasistatic& measured = dataset.quasistatic[number];
  SlowCompression test{.label = fmt::format("{}, compression {}", dataset.name, number + 1),
                       .ball = ball,
                       .platens = measured.platens};
  test.duration = measured.duration.value_or(test.duration);
  const double contact = reach_of_impacts(dataset);
  const double reach = contact * measured.platens;
  if (measured.curve) {
    if (!measured.force_uncertainty)
      seen.warnings.push_back(fmt::format("{}: uncertainty of the force unknown, {:g} % assumed",
                                          test.label, 100 * assumed_force_share));
    add_points(*measured.curve, reach, measured.force_uncertainty.value_or(assumed_force_share),
               test);
  } else if (measured.stiffness.value) {
    const double half = std::isfinite(contact) ? 0.5 * contact : 0.05 * dataset.sphere.diameter;
    const double deflection = half * measured.platens, stiffness = *measured.stiffness.value;
    test.compared_only = !measured.stiffness.is_stated();
    const double share =
        test.compared_only ? assumed_force_share : *measured.stiffness.uncertainty / stiffness;
    test.deflection = {deflection};
    test.force = {stiffness * std::pow(deflection, 1.5)};
    test.error = {share * test.force.front()};
  }
  if (!test.deflection.empty()) seen.compressions.push_back(std::move(test));
}

}  // namespace

void add_slow_tests(const Dataset& dataset, std::size_t ball, Observations& seen) {
  for (std::size_t i = 0; i < dataset.quasistatic.size(); ++i)
    add_compression(dataset, i, ball, seen);
  for (const BlockTest& block : dataset.block_tests) seen.blocks.push_back({ball, block.modulus});
  for (const PooledPeak& peak : dataset.pooled_peaks) seen.pooled_peaks.push_back({ball, peak});
}

}  // namespace rebound
