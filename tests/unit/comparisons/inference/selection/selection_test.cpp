#include "comparisons/inference/selection/selection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "comparisons/inference/references/law_score.hpp"
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

// Neighbours of noise of the first order tell (1 − ρ)/(1 + ρ) of what independent samples do.
TEST(SelectionTest, SamplesThatAreAlikeCountForFewer) {
  constexpr double correlation = 0.8;
  std::vector<MeasuredImpact> references = references_of({.law = "hunt-crossley", .noise = 0.0});
  test::GaussianNoise draw(7);
  for (MeasuredImpact& reference : references) {
    double noise = draw();
    for (double& force : reference.trace.force) {
      force += 5.0 * noise;
      noise = correlation * noise + std::sqrt(1.0 - correlation * correlation) * draw();
    }
    reference.noise.deviation = 5.0;
  }
  const Selection s = select_law(candidates, references);
  EXPECT_GT(s.effective_data, 15.0);
  EXPECT_LT(s.effective_data, 75.0);  // of 303, of which a ninth is 34
}

// BIC of Schwarz 1978: each number costs ln n, and one that is not needed is not worth it.
TEST(SelectionTest, ANumberThatIsNotNeededCosts) {
  const std::vector<Candidate> nested = {
      {"Hunt-Crossley", {.law = "hunt-crossley"}},
      {"its exponent free", {.law = "hunt-crossley", .free = {"exponent"}}}};
  const Selection s = select_law(nested, references_of({.law = "hunt-crossley", .noise = 5.0}));
  const CandidateScore &plain = s.candidates[0], &free = s.candidates[1];
  EXPECT_EQ(free.parameters, plain.parameters + 1);
  EXPECT_NEAR(free.bic - free.misfit - (plain.bic - plain.misfit), std::log(s.effective_data),
              1e-9);
  EXPECT_LT(plain.bic, free.bic);
}

// The ball of the fastest shot is another: a fit that had seen it would be half way there.
TEST(SelectionTest, ASpeedThatIsLeftOutIsNotInTheFit) {
  std::vector<MeasuredImpact> references = references_of({.law = "hunt-crossley", .noise = 0.0});
  MeasuredImpact& fastest = references.back();
  const LumpedModel others{.law = "hunt-crossley",
                           .parameters = test::typical_parameters("hunt-crossley")};
  LumpedModel stiffer = others;
  for (const char* name : {"stiffness", "damping"}) stiffer.parameters[name] *= 1.3;
  const auto run = simulate({fastest.sphere, fastest.impact, stiffer, {.samples = 101}});
  fastest.trace = run.trace;
  fastest.scalars = run.scalars;
  const Selection s = select_law(candidates, references);
  const LeftOut& left_out = s.candidates[1].left_out.back();
  ASSERT_EQ(left_out.speed, 25.0);
  EXPECT_NEAR(left_out.force_rms / score_law(others, fastest).force_time_rms, 1.0, 1e-3);
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
