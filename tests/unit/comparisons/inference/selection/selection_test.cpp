#include "comparisons/inference/selection/selection.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "lumped/integration/simulate.hpp"
#include "lumped/problem/error.hpp"
#include "tests/support/gaussian_noise.hpp"
#include "tests/support/lumped_cases.hpp"

namespace rebound {
namespace {

struct Made {
  std::string law;
  double noise = 1.0;  ///< [N]
  std::vector<double> speeds = {5.0, 15.0, 25.0};
};

std::vector<MeasuredImpact> references_of(const Made& made) {
  test::GaussianNoise draw(5);
  std::vector<MeasuredImpact> references;
  for (double speed : made.speeds) {
    MeasuredImpact r;
    r.label = "made";
    r.sphere = test::core_a();
    r.impact = {.speed = speed, .separation = SeparationRule::zero_force};
    LumpedModel model{.law = made.law, .parameters = test::typical_parameters(made.law)};
    const auto run = simulate({r.sphere, r.impact, model, {.samples = 101}});
    r.trace = run.trace;
    r.scalars = run.scalars;
    r.noise.deviation = made.noise;
    for (double& f : r.trace.force) f += made.noise * draw();
    references.push_back(r);
  }
  return references;
}

const std::vector<Candidate> candidates = {{"spring and dashpot", {.law = "linear-kelvin-voigt"}},
                                           {"Hunt-Crossley", {.law = "hunt-crossley"}},
                                           {"Kuwabara-Kono", {.law = "kuwabara-kono"}},
                                           {"Tsuji", {.law = "tsuji"}}};

TEST(SelectionTest, FindsTheLawThatMadeTheData) {
  const std::pair<const char*, std::size_t> cases[] = {
      {"linear-kelvin-voigt", 0}, {"hunt-crossley", 1}, {"kuwabara-kono", 2}, {"tsuji", 3}};
  for (const auto& [law, index] : cases) {
    const Selection s = select_law(candidates, references_of({.law = law, .noise = 2.0}));
    EXPECT_EQ(s.chosen, std::vector<std::size_t>{index}) << law << ": " << s.verdict;
    EXPECT_LT(*s.candidates[index].prediction_error, 0.01);
    EXPECT_EQ(s.candidates[index].left_out.size(), 3u);
    // White noise keeps most of its number; chance correlation and the tips cost some.
    EXPECT_GT(s.effective_data, 150.0);
    EXPECT_LT(s.effective_data, 304.0);
  }
}

// Two names of one force: nothing can tell them apart, and the answer says so.
TEST(SelectionTest, SaysWhenNothingTells) {
  const std::vector<Candidate> twins = {{"by time", {.law = "kuwabara-kono"}},
                                        {"by coefficient", {.law = "hertz-damped"}},
                                        {"spring and dashpot", {.law = "linear-kelvin-voigt"}}};
  const Selection s = select_law(twins, references_of({.law = "kuwabara-kono"}));
  EXPECT_EQ(s.chosen, (std::vector<std::size_t>{0, 1}));
  EXPECT_NE(s.verdict.find("cannot be told apart"), std::string::npos);
}

TEST(SelectionTest, NoiseHidesTheDifference) {
  const std::vector<Candidate> near = {{"Kuwabara-Kono", {.law = "kuwabara-kono"}},
                                       {"Tsuji", {.law = "tsuji"}}};
  const Selection clear = select_law(near, references_of({.law = "tsuji", .noise = 5.0}));
  EXPECT_EQ(clear.chosen.size(), 1u);
  const Selection hidden = select_law(near, references_of({.law = "tsuji", .noise = 800.0}));
  EXPECT_EQ(hidden.chosen.size(), 2u) << hidden.verdict;
}

TEST(SelectionTest, OneSpeedLeavesTheCriterionAlone) {
  const Selection s = select_law(
      candidates, references_of({.law = "hunt-crossley", .noise = 2.0, .speeds = {15.0}}));
  EXPECT_TRUE(s.candidates[0].left_out.empty());
  EXPECT_TRUE(s.best_by_prediction.empty());
  EXPECT_EQ(s.chosen, std::vector<std::size_t>{1});
  EXPECT_NE(s.verdict.find("alone"), std::string::npos);
}

TEST(SelectionTest, ALawBySpeedCannotPredict) {
  std::vector<Candidate> list = {{"by speed", {.law = "hunt-crossley", .per_speed = {"damping"}}},
                                 {"one damping", {.law = "hunt-crossley"}}};
  const Selection s = select_law(list, references_of({.law = "hunt-crossley"}));
  EXPECT_FALSE(s.candidates[0].prediction_error.has_value());
  EXPECT_FALSE(s.candidates[0].left_out[0].failure.empty());
  EXPECT_EQ(s.chosen, std::vector<std::size_t>{1});
}

TEST(SelectionTest, Refusals) {
  EXPECT_THROW(select_law({candidates[0]}, references_of({.law = "tsuji"})), Error);
  EXPECT_THROW(select_law(candidates, {}), Error);
}

}  // namespace
}  // namespace rebound
