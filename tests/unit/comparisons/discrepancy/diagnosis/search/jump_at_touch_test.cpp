// Effects whose force jumps at first touch: what the first order says of them, and what a fit does.
#include <gtest/gtest.h>

#include "comparisons/discrepancy/diagnosis/observations/observe.hpp"
#include "comparisons/discrepancy/diagnosis/search/assessed_fit.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

/// How often, of ten repetitions, something beside the believed law is seen.
struct Seen {
  int to_first_order = 0, by_a_fit = 0;
};

/// Of a pull of this work [J/m²], under noise whose neighbours are alike: what is left of it once
/// the colour is taken out is the dip at first touch.
Seen seen_of(double work) {
  constexpr int seeds = 10;
  Seen seen;
  for (int seed = 1; seed <= seeds; ++seed) {
    std::vector<EffectChoice> hidden;
    if (work > 0.0) hidden.push_back({"adhesion", work, {}});
    SynthesisFile file = testing::experiment_with(hidden, seed);
    file.sampling.rate = 400e3;
    file.sampling.before = 2e-3;
    file.instrument.noise_correlation_time = 2e-5;  // eight samples
    const Observations data = observe({testing::measured_data(file)});
    const HypothesisFit fit = fit_hypothesis(data, {.believed = testing::believed_law()});
    const std::vector<std::string> effects = absent_effects({});
    const SelectionRules rules;
    AssessedFit believed = judge_by_chi_square(data, fit, rules);
    look_closely(data, EffectSensitivities(data, fit, effects), rules, rules.false_gap_level, 1,
                 known_noise, believed);
    if (!believed.adequate) ++seen.to_first_order;
    if (!judge_believed(data, fit, effects, rules, 1).adequate) ++seen.by_a_fit;
  }
  return seen;
}

// The law's records start where no pull is: to first order the dip is looked for beside where it
// is.
TEST(JumpAtTouchTest, AWeakPullIsSeenByAFit) {
  const Seen seen = seen_of(120.0);
  RecordProperty("to_first_order", seen.to_first_order);
  RecordProperty("by_a_fit", seen.by_a_fit);
  EXPECT_GE(seen.by_a_fit, 8);
  EXPECT_LE(seen.to_first_order, 4);
}

TEST(JumpAtTouchTest, WhereNothingPullsAFitFindsNoMore) {
  const Seen seen = seen_of(0.0);
  RecordProperty("by_a_fit", seen.by_a_fit);
  EXPECT_LE(seen.by_a_fit, 1);
}

}  // namespace
}  // namespace rebound
