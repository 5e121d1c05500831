// What the numbers of a fit cost.
#include "comparisons/discrepancy/diagnosis/fits/hypothesis_fit.hpp"
#include "comparisons/discrepancy/diagnosis/fits/held_out_gap.hpp"

#include <gtest/gtest.h>

#include <cmath>

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

// The formula's own power is no choice of a search; another one is.
TEST(HypothesisFitTest, AShapeThatIsNotTheFormulasOwnCostsAsMuch) {
  EXPECT_NEAR(picked_by_search({"strain-stiffening", 0.3, {}}), 0.0, 1e-9);
  EXPECT_NEAR(picked_by_search({"strain-stiffening", 0.3, {{"power", 2.0}}}), 1.0, 1e-9);
}

TEST(HypothesisFitTest, AFormulaOfOneSizeCostsTwo) {
  EXPECT_NEAR(picked_by_search({"force-exponent", 0.01, {}}), 0.0, 1e-9);
}

/// Deviation of the reduced χ² of shots that no fit saw.
double deviation_where_noise_was_told_by(double samples) {
  const SynthesisFile file = testing::experiment_with({}, 1);
  Observations seen = observe({synthesize(file, simulator_of(file, {})).dataset});
  seen.noise_freedom = samples;
  const HypothesisFit fit = fit_hypothesis(
      seen, {.believed = testing::believed_law(), .effects = {}, .model_discrepancy = nullptr}, {},
      SearchEffort::first_look);
  const HeldOutGap gap = predict_unseen(seen, fit);
  EXPECT_GT(gap.chi_square, 0.0);
  return gap.deviation;
}

// χ² over its data is a ratio of two variances where the noise itself was estimated: √(2/n + 2/ν).
TEST(HypothesisFitTest, NoiseThatWasEstimatedMakesTheUnseenGapLessCertain) {
  const double known = deviation_where_noise_was_told_by(0.0);
  EXPECT_NEAR(deviation_where_noise_was_told_by(200.0), std::hypot(known, 0.1), 1e-12);
  EXPECT_NEAR(deviation_where_noise_was_told_by(1e12), known, 1e-6);
}

}  // namespace
}  // namespace rebound
