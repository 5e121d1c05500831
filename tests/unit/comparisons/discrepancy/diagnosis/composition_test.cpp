// Several effects hidden at once, by formulas of the list.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

/// Little noise and five speeds; a dashpot of this size beside three other effects [N s/m].
Diagnosis diagnose_four(double dashpot) {
  SynthesisFile file = testing::experiment_with({{"relaxation", 0.5, {{"relaxation_time", 0.5e-3}}},
                                                 {"plate-compliance", 2e-8, {{"mass", 5.0}}},
                                                 {"strain-stiffening", 3.0},
                                                 {"linear-dashpot", dashpot}},
                                                9);
  file.instrument.force_noise = 2.0;
  file.shots.clear();
  for (const double speed : {4.0, 8.0, 12.0, 18.0, 25.0})
    file.shots.push_back({.speed = speed, .speed_uncertainty = 1e-3 * speed});
  return testing::diagnose_hidden(file);
}

// 5 N s/m does not show beside the others; they are the whole of the answer.
TEST(CompositionTest, ThreeOfFourThatShowAreNamed) {
  const Diagnosis d = diagnose_four(5.0);
  EXPECT_EQ(d.verdict, DiagnosisVerdict::missing);
  ASSERT_EQ(d.candidates.size(), 1u);
  const std::set<std::string> names(d.candidates[0].begin(), d.candidates[0].end());
  EXPECT_EQ(names, (std::set<std::string>{"plate-compliance", "strain-stiffening", "relaxation"}));
  EXPECT_LT(*d.gap.held_out_after, 1.2);
  EXPECT_GT(*d.gap.held_out_before, 10.0 * *d.gap.held_out_after);
}

// A spectrum of relaxation times bends to what both do, with more numbers than both have; where it
// alone ends the search, half of what is missing is never looked for.
TEST(CompositionTest, TwoEffectsTakeThePlaceOfACurveOfManyNumbers) {
  for (const int seed : {1, 2, 3}) {
    const Diagnosis d = testing::diagnose_hidden(testing::experiment_with(
        {{"strain-stiffening", 1.0, {}}, {"relaxation", 0.1, {{"relaxation_time", 1e-3}}}}, seed));
    EXPECT_TRUE(std::any_of(d.candidates.begin(), d.candidates.end(), [](const auto& names) {
      return std::set<std::string>(names.begin(), names.end()) ==
             std::set<std::string>{"strain-stiffening", "relaxation"};
    })) << seed;
  }
}

// The steps forward reach four effects, and not those that are there: no name is the answer.
TEST(CompositionTest, FourThatAreNotFoundAreNotNamed) {
  const Diagnosis d = diagnose_four(40.0);
  EXPECT_EQ(d.selection.tried.front().fit.effects.size(), 4u);
  EXPECT_EQ(d.verdict, DiagnosisVerdict::unexplained);
  EXPECT_TRUE(d.effects.empty());
}

}  // namespace
}  // namespace rebound
