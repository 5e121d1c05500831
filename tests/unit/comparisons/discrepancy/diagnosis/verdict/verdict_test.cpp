// From candidates to a verdict, on fits that are made for it.
#include "comparisons/discrepancy/diagnosis/verdict/verdict.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/observations/observe.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

/// The believed law and each of these sets beside it, fitted to data with a strong hysteresis; all
/// sets are candidates.
Diagnosis with_candidates(const std::vector<std::vector<std::string>>& sets) {
  const SynthesisFile file = testing::experiment_with({{"hysteresis", 0.4, {}}}, 61);
  Diagnosis d;
  d.seen = std::make_shared<const Observations>(
      observe({synthesize(file, simulator_of(file, {})).dataset}));
  const auto fitted = [&](const std::vector<std::string>& names) {
    Hypothesis one{.believed = testing::believed_law()};
    for (const std::string& name : names)
      one.effects.push_back({name, find_effect(name).card.prior_scale, {}});
    AssessedFit fit;
    fit.fit = fit_hypothesis(*d.seen, one);
    fit.adequate = fit.judged = true;
    return fit;
  };
  d.selection.baseline = fitted({});
  d.believed = d.selection.baseline;
  for (const auto& names : sets) {
    d.selection.indistinguishable.push_back(d.selection.tried.size());
    d.selection.tried.push_back(fitted(names));
  }
  return d;
}

// What three effects follow in two ways, either follows without being it.
TEST(VerdictTest, SeveralSetsOfThreeEffectsAreNoAnswer) {
  Diagnosis threes = with_candidates({{"hysteresis", "damping-exponent", "velocity-exponent"},
                                      {"hysteresis", "damping-exponent", "linear-dashpot"}});
  conclude(threes, {});
  EXPECT_EQ(threes.verdict, DiagnosisVerdict::unexplained);
  EXPECT_NE(threes.withheld.find("three effects and more"), std::string::npos) << threes.withheld;
  EXPECT_TRUE(threes.effects.empty());

  Diagnosis one_of_two = with_candidates(
      {{"hysteresis", "damping-exponent"}, {"hysteresis", "damping-exponent", "linear-dashpot"}});
  conclude(one_of_two, {});
  EXPECT_NE(one_of_two.verdict, DiagnosisVerdict::unexplained);
}

TEST(VerdictTest, ACandidateSaysItsFamilies) {
  Diagnosis d = with_candidates({{"hysteresis", "damping-exponent"}, {"permanent-set"}});
  d.candidates = {{"hysteresis", "damping-exponent"}, {"permanent-set"}};
  EXPECT_EQ(families_of_candidates(d),
            (std::vector<FamilySet>{{EffectFamily::history, EffectFamily::rate},
                                    {EffectFamily::history}}));
  d.candidates = {{"plate-compliance"}};  // of FE
  EXPECT_EQ(families_of_candidates(d), (std::vector<FamilySet>{{EffectFamily::dynamics}}));
}

}  // namespace
}  // namespace rebound
