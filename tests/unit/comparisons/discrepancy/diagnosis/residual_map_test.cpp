#include "comparisons/discrepancy/diagnosis/residual_map.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "comparisons/discrepancy/diagnosis/observe.hpp"
#include "comparisons/discrepancy/diagnosis/selection.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

ResidualMap map_of(const std::vector<EffectChoice>& effects, std::int64_t seed, double level) {
  const SynthesisFile file = testing::experiment_with(effects, seed);
  const Observations seen = observe({synthesize(file, simulator_of(file, {})).dataset});
  const HypothesisFit fit = fit_hypothesis(seen, {.believed = testing::believed_law()});
  return residual_map(seen, fit, EffectSensitivities(seen, fit, {}), level, 1);
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

}  // namespace
}  // namespace rebound
