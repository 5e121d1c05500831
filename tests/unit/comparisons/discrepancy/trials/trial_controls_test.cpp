#include "comparisons/discrepancy/trials/trial_controls.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

/// A diagnosis whose search tried these sets with these criteria, best first.
Diagnosis searched(double baseline,
                   const std::vector<std::pair<std::vector<std::string>, double>>& tried) {
  Diagnosis d;
  d.verdict = DiagnosisVerdict::unexplained;
  d.selection.baseline.fit.information_criterion = baseline;
  for (const auto& [names, criterion] : tried) {
    AssessedFit one;
    one.fit.information_criterion = criterion;
    for (const std::string& name : names) one.fit.effects.push_back({name, 1.0, {}});
    d.selection.tried.push_back(std::move(one));
  }
  d.believed.fit.values = {1.0};
  return d;
}

TEST(TrialControlsTest, TheLowestCriterionWinsWhateverItIs) {
  const TrialAnswer one = lowest_information_criterion(
      searched(300.0, {{{"relaxation"}, 100.0}, {{"linear-dashpot"}, 100.1}}));
  EXPECT_EQ(one.verdict, "missing");
  EXPECT_EQ(one.named, "relaxation");
  EXPECT_EQ(one.family, "memory");
  EXPECT_EQ(lowest_information_criterion(searched(90.0, {{{"relaxation"}, 100.0}})).verdict,
            "agrees");
  EXPECT_EQ(lowest_information_criterion(searched(300.0, {{{"hum"}, 100.0}})).verdict,
            "measurement-fault");
  const TrialAnswer curve =
      lowest_information_criterion(searched(300.0, {{{"elastic-curve"}, 1.0}}));
  EXPECT_EQ(curve.verdict, "family");
  EXPECT_EQ(curve.family, "elastic");
  EXPECT_TRUE(curve.named.empty());
}

TEST(TrialControlsTest, ASetSaysTheFamilyOfTheMemberThatDoesBestAlone) {
  const TrialAnswer set = lowest_information_criterion(searched(
      300.0, {{{"adhesion", "relaxation"}, 50.0}, {{"relaxation"}, 100.0}, {{"adhesion"}, 200.0}}));
  EXPECT_EQ(set.family, "memory");
  EXPECT_TRUE(set.named.empty());
  EXPECT_EQ(set.candidates.front().size(), 2u);
}

TEST(TrialControlsTest, TheRandomAnswerIsThatOfItsSeedAndData) {
  const Diagnosis d = searched(1.0, {});
  std::set<std::string> families;
  int nothing = 0;
  constexpr int trials = 400;
  for (int i = 0; i < trials; ++i) {
    const std::string data = "trial " + std::to_string(i);
    const TrialAnswer answer = random_answer(d, 1, data);
    EXPECT_EQ(answer, random_answer(d, 1, data));
    families.insert(answer.family);
    nothing += answer.verdict == "agrees";
    if (answer.verdict != "agrees") {
      EXPECT_FALSE(find_effect(answer.named).card.is_free_form);
    }
  }
  EXPECT_EQ(families.size(), 8u) << "seven families and none";
  EXPECT_NEAR(nothing, trials / 8.0, 25.0);  // four deviations of a binomial draw
}

TEST(TrialControlsTest, WithoutDataForAVerdictTheyAbstain) {
  const std::map<std::string, TrialAnswer> answers = answers_of_controls(Diagnosis{}, 1, "data");
  EXPECT_EQ(answers.at("lowest-information-criterion").verdict, "insufficient-data");
  EXPECT_EQ(answers.at("sparse-regression").verdict, "insufficient-data");
  EXPECT_EQ(answers.size(), std::size(control_names));
}

// A plain effect, which every method that looks at the data should find.
TEST(TrialControlsTest, OnAPlainEffectTheyAreRightToo) {
  constexpr int seeds = 3;
  int lowest = 0, sparse = 0;
  for (int seed = 0; seed < seeds; ++seed) {
    const Diagnosis d =
        testing::diagnose_hidden(testing::experiment_with({{"force-exponent", 0.15, {}}}, seed));
    lowest += lowest_information_criterion(d).family == "elastic";
    sparse += sparse_regression_answer(d).family == "elastic";
  }
  EXPECT_GE(lowest, 2);
  EXPECT_GE(sparse, 2);
}

}  // namespace
}  // namespace rebound
