// What the numbers of a fit cost.
#include "comparisons/discrepancy/diagnosis/hypothesis_fit.hpp"

#include <gtest/gtest.h>

#include "comparisons/discrepancy/diagnosis/observations/observe.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

/// By how much more than 2 a number χ² + 2 k takes for an effect, in what χ² + k ln N takes more.
double picked_by_search(const EffectChoice& effect) {
  const SynthesisFile file = testing::experiment_with({}, 1);
  const Observations seen = observe({synthesize(file, simulator_of(file, {})).dataset});
  const HypothesisFit fit = fit_hypothesis(
      seen,
      {.believed = testing::believed_law(), .effects = {effect}, .model_discrepancy = nullptr}, {},
      SearchEffort::first_look);
  const double each = (fit.information_criterion - fit.chi_square) / fit.effect_unknowns;
  EXPECT_GT(each, 4.0);  // ln N of some hundred data
  return (fit.prediction_criterion - fit.chi_square - 2.0 * fit.effect_unknowns) / (each - 2.0);
}

TEST(HypothesisFitTest, AFrequencyThatWasPickedFromManyCostsMore) {
  EXPECT_NEAR(picked_by_search({"plate-compliance", 1e-9, {}}), 1.0, 1e-9);
  EXPECT_NEAR(picked_by_search({"hum", 1.0, {{"frequency", 2e3}}}), 1.0, 1e-9);
}

TEST(HypothesisFitTest, AFormulaOfOneSizeCostsTwo) {
  EXPECT_NEAR(picked_by_search({"force-exponent", 0.01, {}}), 0.0, 1e-9);
}

}  // namespace
}  // namespace rebound
