#include "comparisons/discrepancy/diagnosis/search/residual_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/diagnosis/observations/observe.hpp"
#include "comparisons/discrepancy/diagnosis/search/selection.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

ResidualMap map_of(const Dataset& dataset, double level) {
  const Observations seen = observe({dataset});
  const HypothesisFit fit = fit_hypothesis(seen, {.believed = testing::believed_law()});
  return residual_map(seen, fit, EffectSensitivities(seen, fit, {}), level, 1);
}

Dataset measured(const SynthesisFile& file) {
  return synthesize(file, simulator_of(file, {})).dataset;
}

ResidualMap map_of(const std::vector<EffectChoice>& effects, std::int64_t seed, double level) {
  return map_of(measured(testing::experiment_with(effects, seed)), level);
}

TEST(ResidualMapTest, NoiseIsQuiet) {
  // At a level of one half, 40 maps of noise pass the threshold 20 times; three
  // standard deviations of that count are 9.5.
  int loud = 0;
  for (int seed = 200; seed < 240; ++seed) loud += map_of({}, seed, 0.5).quiet() ? 0 : 1;
  EXPECT_NEAR(loud, 20, 9.5);
}

TEST(ResidualMapTest, AnEffectIsSeenWhereItActs) {
  const ResidualMap map = map_of({{"hysteresis", 0.3, {}}}, 5, 0.02);
  EXPECT_FALSE(map.quiet());
  double onset = 0.0, unloading = 0.0;
  for (const MapCell& cell : map.cells) {
    if (cell.phase == Phase::onset) onset = std::max(onset, std::abs(cell.z));
    if (cell.phase == Phase::unloading) unloading = std::max(unloading, std::abs(cell.z));
  }
  EXPECT_GT(unloading, onset);  // the law is untouched while it loads
}

struct Stretch {
  Phase phase;
  double from, to;  // of the peak force
  bool rising;
};

/// The measured data with a second shot whose readings are three times the noise too high on one
/// stretch of the true pulse.
Dataset lifted_on(const Stretch& stretch, std::int64_t seed) {
  SynthesisFile file = testing::experiment_with({}, seed);
  Dataset dataset = measured(file);
  file.instrument.force_noise = 0.0;
  const std::vector<double> force = measured(file).shots[1].trace.force;
  const auto top = std::max_element(force.begin(), force.end()) - force.begin();
  for (std::size_t i = 0; i < force.size(); ++i) {
    const double share = force[i] / force[static_cast<std::size_t>(top)];
    const bool rising = static_cast<std::ptrdiff_t>(i) <= top;
    if (share > stretch.from && share < stretch.to && rising == stretch.rising)
      dataset.shots[1].trace.force[i] += 60.0;
  }
  return dataset;
}

/// The phase of the second shot where the residuals, model less data, are lowest.
Phase lowest(const ResidualMap& map) {
  const MapCell* found = nullptr;
  for (const MapCell& cell : map.cells)
    if (cell.shot == 1 && (!found || cell.z < found->z)) found = &cell;
  return found->phase;
}

TEST(ResidualMapTest, AStretchOfTheRecordIsSeenInItsPhase) {
  for (const Stretch& stretch : {Stretch{Phase::onset, 0.02, 0.18, true},
                                 {Phase::loading, 0.25, 0.85, true},
                                 {Phase::unloading, 0.25, 0.85, false},
                                 {Phase::release, 0.02, 0.18, false}})
    for (int seed = 300; seed < 305; ++seed)
      EXPECT_EQ(name_of(lowest(map_of(lifted_on(stretch, seed), 0.02))), name_of(stretch.phase))
          << seed;
}

}  // namespace
}  // namespace rebound
