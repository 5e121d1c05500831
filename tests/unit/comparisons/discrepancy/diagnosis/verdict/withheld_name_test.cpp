// What an unseen speed takes away from a verdict, rule by rule.
#include "comparisons/discrepancy/diagnosis/verdict/withheld_name.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/output/diagnosis_text.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

/// Two candidates of no common family, of which noise could do as much.
Diagnosis small_gap() {
  Diagnosis d;
  d.verdict = DiagnosisVerdict::one_of;
  d.family = EffectFamily::none;
  d.candidates = {{"hum"}, {"force-exponent"}};
  d.believed.p_value = 0.2;
  d.selection.tried.resize(2);
  d.selection.indistinguishable = {0, 1};
  d.gap.held_out_before = 1.05;
  d.gap.held_out_after = 1.08;
  d.gap.held_out_noise = 0.04;
  return d;
}

DiagnosisVerdict verdict_of(Diagnosis d) {
  withhold_what_the_unseen_speed_denies(d, {});
  return d.verdict;
}

TEST(WithheldNameTest, CandidatesThatHelpNowhereLeaveTheBelievedModel) {
  Diagnosis d = small_gap();
  withhold_what_the_unseen_speed_denies(d, {});
  EXPECT_EQ(d.verdict, DiagnosisVerdict::agrees);
  EXPECT_TRUE(d.candidates.empty());
  EXPECT_TRUE(d.selection.indistinguishable.empty());
  EXPECT_FALSE(d.gap.held_out_after);
  EXPECT_NE(d.withheld.find("1.05"), std::string::npos) << d.withheld;
}

// Each condition alone keeps the candidates.
TEST(WithheldNameTest, WhatNoiseCouldNotDoKeepsItsCandidates) {
  Diagnosis d = small_gap();
  d.believed.p_value = 1e-4;
  EXPECT_EQ(verdict_of(d), DiagnosisVerdict::one_of);
  d = small_gap();
  d.family = EffectFamily::elastic;
  EXPECT_EQ(verdict_of(d), DiagnosisVerdict::one_of);
  d = small_gap();
  d.gap.held_out_after = 1.02;
  EXPECT_EQ(verdict_of(d), DiagnosisVerdict::one_of);
  d = small_gap();
  d.gap.held_out_before = 1.3;
  d.gap.held_out_after = 1.1;
  EXPECT_EQ(verdict_of(d), DiagnosisVerdict::one_of);
}

// χ² over all readings may pass where one phase of one shot is plainly off.
TEST(WithheldNameTest, AGapThatIsPlainInOneCellKeepsItsCandidates) {
  Diagnosis d = small_gap();
  d.believed.map.threshold = 3.6;
  d.believed.map.largest = 5.6;
  EXPECT_EQ(verdict_of(d), DiagnosisVerdict::one_of);
  d.believed.map.largest = 3.9;
  EXPECT_EQ(verdict_of(d), DiagnosisVerdict::agrees);
}

// χ² of two thousand readings may pass where a single number brings fifty.
TEST(WithheldNameTest, WhatGainsMoreThanNoiseGivesKeepsItsCandidates) {
  Diagnosis d = small_gap();
  d.selection.baseline.fit.prediction_criterion = 2000.0;
  d.selection.tried[0].fit.prediction_criterion = 1990.0;
  d.selection.tried[1].fit.prediction_criterion = 1985.0;
  EXPECT_EQ(verdict_of(d), DiagnosisVerdict::agrees);
  d.selection.tried[1].fit.prediction_criterion = 1947.0;
  EXPECT_EQ(verdict_of(d), DiagnosisVerdict::one_of);
}

/// One candidate of these effects, which have no family in common.
Diagnosis explained_by(const std::vector<std::string>& names) {
  Diagnosis d;
  d.seen = std::make_shared<const Observations>();
  d.candidates = {names};
  d.selection.tried.resize(1);
  for (const std::string& name : names)
    d.selection.tried[0].fit.effects.push_back({.name = name, .size = 0.1, .parameters = {}});
  d.selection.indistinguishable = {0};
  return d;
}

TEST(WithheldNameTest, WhatAPairOfFamiliesExplainsIsNotUnexplained) {
  const Diagnosis pair = explained_by({"pull-curves", "force-exponent"});
  EXPECT_EQ(without_name(pair), DiagnosisVerdict::family);
  EXPECT_EQ(family_in_words(pair), "of the families 'surface' and 'elastic'");
  EXPECT_EQ(without_name(explained_by({"strain-stiffening", "force-exponent"})),
            DiagnosisVerdict::unexplained);
}

// A fault beside an effect fits whatever the effect leaves, and so do three effects together.
TEST(WithheldNameTest, WhatAFaultOrAThirdEffectCompletesStaysUnexplained) {
  for (const std::vector<std::string>& names :
       {std::vector<std::string>{"damping-curves", "trigger-shift"},
        {"pull-curves", "force-exponent", "hysteresis"},
        {"pull-curves"}})
    EXPECT_EQ(without_name(explained_by(names)), DiagnosisVerdict::unexplained) << names.size();
  Diagnosis two = explained_by({"pull-curves", "force-exponent"});
  two.candidates.push_back({"pull-curves", "hysteresis"});
  EXPECT_EQ(without_name(two), DiagnosisVerdict::unexplained);
}

TEST(WithheldNameTest, AGapThatStaysIsUnexplained) {
  Diagnosis d = small_gap();
  d.gap.held_out_before = 3.0;
  d.gap.held_out_after = 2.5;
  EXPECT_EQ(verdict_of(d), DiagnosisVerdict::unexplained);
}

TEST(WithheldNameTest, ANameNeedsAGapThatClosesAtTheUnseenSpeed) {
  Diagnosis d = small_gap();
  d.verdict = DiagnosisVerdict::missing;
  d.family = EffectFamily::elastic;
  EXPECT_EQ(verdict_of(d), DiagnosisVerdict::family);
  d.gap.held_out_before = 3.0;
  d.gap.held_out_after = 1.05;
  EXPECT_EQ(verdict_of(d), DiagnosisVerdict::missing);
}

/// A family that leaves a gap where there was none, and not by noise.
TEST(WithheldNameTest, AFamilyThatOpensAGapAtTheUnseenSpeedIsDenied) {
  Diagnosis d = explained_by({"elastic-curve"});
  d.verdict = DiagnosisVerdict::family;
  d.family = EffectFamily::elastic;
  d.gap.held_out_noise = 0.04;
  d.gap.held_out_before = 1.05;
  d.gap.held_out_after = 1.4;
  d.unseen_before = HeldOutGap{.chi_square = 500.0};
  d.unseen_after = HeldOutGap{.chi_square = 660.0};
  d.believed.p_value = 0.01;  // the gap that was seen is one that noise may make
  EXPECT_EQ(verdict_of(d), DiagnosisVerdict::agrees);
  d.believed.map.threshold = 3.6;
  d.believed.map.largest = 5.6;  // a cell such as noise does not make
  EXPECT_EQ(verdict_of(d), DiagnosisVerdict::unexplained);
  d.believed.map.largest = 3.9;
  EXPECT_EQ(verdict_of(d), DiagnosisVerdict::agrees);
  d.believed.p_value = 1e-6;
  EXPECT_EQ(verdict_of(d), DiagnosisVerdict::unexplained);
  d.unseen_after->chi_square = 503.0;
  EXPECT_EQ(verdict_of(d), d.verdict) << "what noise does to a χ² denies nothing";
}

/// A fault of the measurement that the unseen speed is as far from as before.
Diagnosis fault_that_misses(const std::string& name) {
  Diagnosis d = small_gap();
  d.verdict = DiagnosisVerdict::measurement_fault;
  d.family = EffectFamily::measurement;
  d.candidates = {{name}};
  d.selection.indistinguishable = {0};
  d.fault = name;
  d.gap.held_out_before = 3.0;
  d.gap.held_out_after = 2.5;
  return d;
}

TEST(WithheldNameTest, AFaultOfAllShotsWouldBeThereAtTheUnseenSpeed) {
  Diagnosis d = fault_that_misses("clipping");
  withhold_what_the_unseen_speed_denies(d, {});
  EXPECT_EQ(d.verdict, DiagnosisVerdict::unexplained);
  EXPECT_TRUE(d.fault.empty());
}

TEST(WithheldNameTest, OneThatThatSpeedMeetsStays) {
  Diagnosis d = fault_that_misses("clipping");
  d.gap.held_out_after = 1.05;
  EXPECT_EQ(verdict_of(d), DiagnosisVerdict::measurement_fault);
}

TEST(WithheldNameTest, AFaultOfOneShotIsNotAtTheUnseenSpeed) {
  EXPECT_EQ(verdict_of(fault_that_misses("odd-shot")), DiagnosisVerdict::measurement_fault);
}

/// Small, and yet its own prediction fits worse: noise that passed for it.
TEST(WithheldNameTest, AFaultThatOnlyMakesTheUnseenSpeedWorseIsNone) {
  const auto said = [](const char* name, double rise) {
    Diagnosis d = fault_that_misses(name);
    d.gap.held_out_before = 0.96;
    d.gap.held_out_after = 0.98;
    d.unseen_before = HeldOutGap{.chi_square = 500.0};
    d.unseen_after = HeldOutGap{.chi_square = 500.0 + rise};
    return verdict_of(d);
  };
  EXPECT_EQ(said("hum", 10.0), DiagnosisVerdict::unexplained);
  EXPECT_EQ(said("hum", 2.0), DiagnosisVerdict::measurement_fault);
  EXPECT_EQ(said("odd-shot", 10.0), DiagnosisVerdict::measurement_fault);
}

/// A family that explains what is no more than FE's own errors, and is not seen where none looked.
Diagnosis small_gap_beside_fem() {
  Diagnosis d = small_gap();
  d.verdict = DiagnosisVerdict::family;
  d.family = EffectFamily::elastic;
  d.model_discrepancy = std::make_shared<const ModelDiscrepancy>();
  d.gap.held_out_after = 1.0;
  return d;
}

TEST(WithheldNameTest, WhatIsWithinTheErrorsOfFemIsNoGap) {
  Diagnosis d = small_gap_beside_fem();
  d.fault = "hum";
  withhold_what_the_unseen_speed_denies(d, {});
  EXPECT_EQ(d.verdict, DiagnosisVerdict::agrees);
  EXPECT_EQ(d.family, EffectFamily::none);
  EXPECT_TRUE(d.fault.empty());
}

// Each condition alone keeps the family.
TEST(WithheldNameTest, WhatIsBeyondTheErrorsOfFemKeepsItsFamily) {
  Diagnosis d = small_gap_beside_fem();
  d.believed.p_value = 1e-4;
  EXPECT_EQ(verdict_of(d), DiagnosisVerdict::family);
  d = small_gap_beside_fem();
  d.model_discrepancy = nullptr;
  EXPECT_EQ(verdict_of(d), DiagnosisVerdict::family);
  d = small_gap_beside_fem();
  d.gap.held_out_before = 1.3;
  EXPECT_EQ(verdict_of(d), DiagnosisVerdict::family);
  d = small_gap_beside_fem();
  ModelDiscrepancy coarse;
  coarse.numerical_uncertainty = 0.1;
  d.model_discrepancy = std::make_shared<const ModelDiscrepancy>(coarse);
  EXPECT_EQ(verdict_of(d), DiagnosisVerdict::family) << "everything is within such errors";
  d = small_gap_beside_fem();
  d.selection.baseline.fit.chi_square = 400.0;
  for (AssessedFit& one : d.selection.tried) one.fit.chi_square = 350.0;
  EXPECT_EQ(verdict_of(d), DiagnosisVerdict::agrees);
  for (AssessedFit& one : d.selection.tried) one.fit.chi_square = 330.0;
  EXPECT_EQ(verdict_of(d), DiagnosisVerdict::family) << "no errors of a mesh gain as much";
}

}  // namespace
}  // namespace rebound
