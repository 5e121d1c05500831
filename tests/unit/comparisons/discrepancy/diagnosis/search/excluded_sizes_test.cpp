#include "comparisons/discrepancy/diagnosis/search/excluded_sizes.hpp"

#include <gtest/gtest.h>

#include "comparisons/discrepancy/diagnosis/observations/observe.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

// A size is excluded when it would show whatever the further parameters of the effect are: of
// relaxation, at the time at which it shows least.
TEST(ExcludedSizesTest, ShowsAtEveryPointOfTheParameters) {
  constexpr double seen = 2.706;  // of χ²: 95 % of one side
  int found = 0;
  for (int seed = 60; seed < 63; ++seed) {
    const SynthesisFile file = testing::experiment_with({}, seed);
    const Observations data = observe({synthesize(file, simulator_of(file, {})).dataset});
    const HypothesisFit fit = fit_hypothesis(data, {.believed = testing::believed_law()});
    const EffectSensitivities around(data, fit, {"relaxation", "hysteresis", "adhesion"});
    for (const ExcludedSize& excluded : excluded_sizes(around)) {
      ++found;
      const EffectCard& card = find_effect(excluded.name).card;
      double least = 1e300;
      for (EffectChoice& choice : around.over_its_parameters(card)) {
        choice.size = card.null + excluded.size;
        const auto rise = around.rise(choice);
        ASSERT_TRUE(rise.has_value()) << excluded.name;
        least = std::min(least, *rise);
      }
      EXPECT_GE(least, seen) << excluded.name << " " << seed;
      // Sizes are found to a tenth, and χ² grows with their square.
      EXPECT_LE(least, 2.0 * seen) << excluded.name << " " << seed;
    }
  }
  EXPECT_GE(found, 3);
}

}  // namespace
}  // namespace rebound
