#include "comparisons/discrepancy/diagnosis/search/effect_sensitivities.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

#include "comparisons/discrepancy/diagnosis/observations/observe.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

/// What first-order algebra says around the believed law, fitted to one experiment.
struct Around {
  Around(const std::vector<EffectChoice>& hidden, std::int64_t seed,
         const std::vector<std::string>& effects)
      : file(testing::experiment_with(hidden, seed)),
        seen(observe({synthesize(file, simulator_of(file, {})).dataset})),
        fit(fit_hypothesis(seen, {.believed = testing::believed_law()})),
        around(seen, fit, effects) {}
  SynthesisFile file;
  Observations seen;
  HypothesisFit fit;
  EffectSensitivities around;
};

// A small effect is found to first order, as far from its size as the error says.
TEST(EffectSensitivitiesTest, TheSizeOfASmallEffectIsFoundWithinItsError) {
  constexpr int seeds = 20;
  for (const EffectChoice& hidden :
       {EffectChoice{"hysteresis", 0.02, {}}, EffectChoice{"force-exponent", -0.01, {}}}) {
    double mean = 0.0, square = 0.0;
    for (int seed = 400; seed < 400 + seeds; ++seed) {
      const Around one({hidden}, seed, {hidden.name});
      const auto scores = one.around.scores();
      ASSERT_EQ(scores.size(), 1u);
      const double z = (scores[0].size - hidden.size) / scores[0].size_error;
      mean += z / seeds;
      square += z * z / seeds;
      if (hidden.size < 0.0) {  // of either sign: its gain is the square of its size over the error
        EXPECT_NEAR(scores[0].gain_chi_square, std::pow(scores[0].size / scores[0].size_error, 2),
                    1e-9);
      }
    }
    EXPECT_NEAR(mean, 0.0, 4.0 / std::sqrt(seeds)) << hidden.name;
    EXPECT_NEAR(std::sqrt(square), 1.0, 4.0 / std::sqrt(2.0 * seeds)) << hidden.name;
  }
}

// Of nothing hidden, at a level of one half: 20 of 40, and three standard deviations are 9.5.
TEST(EffectSensitivitiesTest, NoiseExceedsTheThresholdAsOftenAsItsLevelSays) {
  int exceeded = 0;
  for (int seed = 500; seed < 540; ++seed) {
    // Of either sign: where noise asks for the other sign of a one-sided effect it gains nothing.
    const Around one({}, seed, {"force-exponent", "damping-exponent", "velocity-exponent"});
    double best = 0.0;
    for (const EffectScore& score : one.around.scores())
      best = std::max(best, score.gain_chi_square);
    exceeded += best > one.around.threshold(0.5, 1) ? 1 : 0;
  }
  EXPECT_NEAR(exceeded, 20, 9.5);
}

// The largest of one square of a normal number: 1.96², three standard errors of 4000 draws.
TEST(EffectSensitivitiesTest, TheThresholdOfOneEffectIsThatOfChiSquare) {
  const Around one({}, 500, {"damping-exponent"});
  ASSERT_EQ(one.around.all().size(), 1u);
  EXPECT_NEAR(one.around.threshold(0.05, 1), 3.84, 0.32);
}

// Damping that follows or not, the formula's own depth or another one: a search from the best of
// each.
TEST(EffectSensitivitiesTest, EveryVariantOfAnEffectHasItsStart) {
  Around one({{"layered-core", 0.5, {}}}, 501, {"layered-core", "hysteresis"});
  one.around.look_for_starts();
  std::set<std::pair<bool, bool>> variants;
  const auto starts = one.around.starts("layered-core", 2);
  for (const EffectChoice& start : starts)
    variants.insert({start.parameters.at("damping_share") == 1.0,
                     start.parameters.at("depth_over_radius") == 0.1});
  EXPECT_EQ(starts.size(), 4u);
  EXPECT_EQ(variants.size(), 4u);
  EXPECT_EQ(one.around.starts("hysteresis", 2).size(), 2u);
}

// Of a law that is free the damping takes out what it changes; of one that the data hold at a bound
// it could take out no more than the bound allows, which is nothing.
TEST(EffectSensitivitiesTest, ANumberAtItsBoundTakesNothingOutOfWhatIsMissing) {
  const SynthesisFile file = testing::experiment_with({}, 500);
  const Observations seen = observe({synthesize(file, simulator_of(file, {})).dataset});
  const auto left_of_damping = [&](double believed_damping, Identifiability expected) {
    LumpedModel believed = testing::believed_law();
    believed.parameters["damping"] = believed_damping;
    const HypothesisFit fit = fit_hypothesis(seen, {.believed = believed});
    std::size_t damping = 0;
    while (fit.model->unknowns().at(damping).name != "damping") ++damping;
    EXPECT_EQ(fit.search.estimates[damping].identifiability, expected);
    const Eigen::VectorXd column =
        jacobian_at(*fit.model, fit.values).col(static_cast<Eigen::Index>(damping));
    const EffectSensitivities around(seen, fit, {"hysteresis"});
    return around.project(column).norm() / column.norm();
  };
  constexpr double fitted = 8e4, far_too_much = 8e4 * 100.0;  // bounds: a factor of e³ either way
  EXPECT_LT(left_of_damping(fitted, Identifiability::identified), 1e-6);
  EXPECT_GT(left_of_damping(far_too_much, Identifiability::at_bound), 0.1);
}

// Hysteresis takes energy away: data that ask for the opposite give it nothing.
TEST(EffectSensitivitiesTest, TheWrongSideOfAnEffectGainsNothing) {
  int wrong = 0;
  for (int seed = 400; seed < 420; ++seed) {
    const Around one({}, seed, {"hysteresis"});
    const EffectScore score = one.around.scores().at(0);
    wrong += score.size < 0.0 ? 1 : 0;
    EXPECT_EQ(score.gain_chi_square > 0.0, score.size > 0.0) << seed;
  }
  EXPECT_GE(wrong, 3);  // of 20 about half
}

}  // namespace
}  // namespace rebound
