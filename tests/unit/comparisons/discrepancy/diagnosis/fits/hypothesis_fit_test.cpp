// What the numbers of a fit cost.
#include "comparisons/discrepancy/diagnosis/fits/hypothesis_fit.hpp"
#include "comparisons/discrepancy/diagnosis/fits/held_out_gap.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "comparisons/discrepancy/diagnosis/observations/observe.hpp"
#include "lumped/mechanisms/unloading_memory.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/fits/smooth_noise.hpp"
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

HypothesisFit fit_of(const EffectChoice& effect, const std::vector<EffectChoice>& hidden) {
  const SynthesisFile file = testing::experiment_with(hidden, 1);
  const Observations seen = observe({synthesize(file, simulator_of(file, {})).dataset});
  return fit_hypothesis(
      seen,
      {.believed = testing::believed_law(), .effects = {effect}, .model_discrepancy = nullptr});
}

/// Unloading of Walton and Braun, (1 + s) F_e(x) − s F_e(x_max), by its points.
EffectChoice stiff_unloading(double s) {
  const auto point = [s](int k) {
    return -s * (1.0 - std::pow(unloading_share(0.2 * static_cast<double>(k)), 1.5));
  };
  return {"unloading-curve",
          -point(2),
          {{"at_0", point(0)}, {"at_1", point(1)}, {"at_3", point(3)}, {"at_4", point(4)}}};
}

// A bow is few numbers, and no memory passes for it with fewer: as six numbers it was behind.
TEST(HypothesisFitTest, AStiffUnloadingCostsLessThanItsPoints) {
  const EffectChoice hidden = stiff_unloading(0.06);
  const HypothesisFit curve = fit_of({"unloading-curve", 0.0, {}}, {hidden});
  EXPECT_LT(curve.effect_unknowns, 4.5);
  EXPECT_GE(curve.effect_unknowns, 1.0);
  EXPECT_LT(curve.reduced_chi_square(), 1.2);
  const HypothesisFit memory = fit_of({"relaxation", 0.1, {}}, {hidden});
  EXPECT_LT(curve.information_criterion, memory.information_criterion);
}

// A spectrum whose fast and slow times carry nothing is one time, and the power of its spring.
TEST(HypothesisFitTest, AShareThatDataHoldAtNoneIsNoNumber) {
  const EffectChoice hidden{"relaxation", 0.3, {{"relaxation_time", 5e-4}}};
  const HypothesisFit one = fit_of(
      {"relaxation-spectrum", 0.3, {{"relaxation_time", 5e-4}, {"fast_ratio", 0.0}}}, {hidden});
  const EffectChoice& found = one.effects.back();
  const int held =
      (found.parameters.at("fast_ratio") == 0.0) + (found.parameters.at("slow_ratio") == 0.0);
  EXPECT_GE(held, 1);
  EXPECT_LE(one.effect_unknowns, 5.0 - held);
  // A refit to other data may use it.
  EXPECT_GT(one.penalty_of_refits, one.information_criterion - one.chi_square + 5.0 * held);
}

TEST(HypothesisFitTest, AFormulaOfOneSizeCostsTwo) {
  EXPECT_NEAR(picked_by_search({"force-exponent", 0.01, {}}), 0.0, 1e-9);
}

/// A slow relaxation and a softer law leave nearly the same behind: the data say its size over its
/// time, and hardly either alone. Smooth noise leaves hardly anything to chance from one sample to
/// the next, so that samples at which a contact ends decide, and are walls to a search by slopes.
HypothesisFit slow_relaxation_found(const Observations& seen, double of_hidden) {
  const EffectChoice start{
      "relaxation", 0.26 * of_hidden, {{"relaxation_time", 1.3e-3 * of_hidden}}};
  return fit_hypothesis(
      seen,
      {.believed = testing::believed_law(), .effects = {start}, .model_discrepancy = nullptr});
}

Observations with_slow_relaxation(int seed) {
  const EffectChoice hidden{"relaxation", 0.26, {{"relaxation_time", 1.3e-3}}};
  return observe({testing::under_smooth_noise(hidden, 0.1, seed)});
}

TEST(HypothesisFitTest, SlowRelaxationIsFoundFromAnyStart) {
  for (const int seed : {1, 2, 3}) {
    const Observations seen = with_slow_relaxation(seed);
    const double from_hidden = slow_relaxation_found(seen, 1.0).chi_square;
    EXPECT_LT(from_hidden,
              static_cast<double>(seen.shots.size() * seen.shots[0].trace.time.size()));
    EXPECT_NEAR(slow_relaxation_found(seen, 2.0).chi_square, from_hidden, 0.1) << seed;
  }
}

TEST(HypothesisFitTest, IntervalsHoldASlowRelaxation) {
  constexpr int seeds = 8;
  int held = 0;
  for (int seed = 1; seed <= seeds; ++seed)
    for (const Estimate& one :
         slow_relaxation_found(with_slow_relaxation(seed), 1.0).search.estimates)
      held += one.name == "relaxation" && one.low <= 0.26 && 0.26 <= one.high;
  EXPECT_GE(held, seeds - 2);
}

TEST(HypothesisFitTest, AReadingIsAMeanUnderNoiseWithAColourAlone) {
  const Observations smooth = with_slow_relaxation(1);
  const HypothesisFit fit = slow_relaxation_found(smooth, 1.0);
  const std::vector<double>& time = smooth.shots[0].trace.time;
  EXPECT_NEAR(fit.model->chain_at(fit.values, 0).aperture, 0.05 * (time[1] - time[0]),
              1e-4 * (time[1] - time[0]));
  const Observations white = observe({testing::measured_data(testing::experiment_with({}, 1))});
  const HypothesisFit law = fit_hypothesis(
      white, {.believed = testing::believed_law(), .effects = {}, .model_discrepancy = nullptr});
  EXPECT_EQ(law.model->chain_at(law.values, 0).aperture, 0.0);
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
