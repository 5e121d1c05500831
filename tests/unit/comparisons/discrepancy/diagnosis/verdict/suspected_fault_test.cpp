#include "comparisons/discrepancy/diagnosis/verdict/suspected_fault.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "comparisons/discrepancy/diagnosis/data_checks/data_checks.hpp"
#include "comparisons/discrepancy/diagnosis/observations/observe.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

/// Restitutions of their own; the forces of the given shots are too large by this factor.
Observations with_shots_times(const std::vector<std::size_t>& shots, double factor) {
  SynthesisFile file = testing::experiment_with({}, 1);
  for (SynthesisShot& shot : file.shots) shot.restitution_uncertainty = 0.01;
  Dataset dataset = synthesize(file, simulator_of(file, {})).dataset;
  for (const std::size_t i : shots)
    for (double& force : dataset.shots[i].trace.force) force *= factor;
  return observe({dataset});
}

Observations with_second_shot_times(double factor) {
  return with_shots_times({1}, factor);
}

Diagnosis suspected(const Observations& all, DiagnosisVerdict verdict) {
  Diagnosis d;
  d.seen = std::make_shared<const Observations>(all);
  d.checks = check_data(all);
  d.contradictions = contradictions_among(d.checks);
  d.selection.baseline.fit =
      fit_hypothesis(all, {.believed = testing::believed_law(), .effects = {}});
  d.verdict = verdict;
  suspect_what_contradicts_momentum(d, all);
  return d;
}

TEST(SuspectedFaultTest, AShotAgainstItsImpulseIsAFault) {
  const Observations all = with_second_shot_times(1.3);
  const Diagnosis d = suspected(all, DiagnosisVerdict::unexplained);
  EXPECT_EQ(d.verdict, DiagnosisVerdict::measurement_fault);
  EXPECT_EQ(d.family, EffectFamily::measurement);
  EXPECT_NE(d.fault.find(all.shots[1].label), std::string::npos) << d.fault;
}

/// A magnet below the plate pulls in all shots, and so may a gain that no list holds.
TEST(SuspectedFaultTest, AllShotsAgainstTheirImpulseAreUnexplained) {
  const Diagnosis d = suspected(with_shots_times({0, 1, 2}, 1.3), DiagnosisVerdict::unexplained);
  EXPECT_EQ(d.verdict, DiagnosisVerdict::unexplained);
  EXPECT_NE(d.withheld.find("momentum is contradicted in the impulse"), std::string::npos)
      << d.withheld;
}

TEST(SuspectedFaultTest, WithoutAContradictionNothingIsSuspected) {
  EXPECT_EQ(suspected(with_second_shot_times(1.0), DiagnosisVerdict::unexplained).verdict,
            DiagnosisVerdict::unexplained);
}

TEST(SuspectedFaultTest, WhatIsExplainedStands) {
  EXPECT_EQ(suspected(with_second_shot_times(1.3), DiagnosisVerdict::missing).verdict,
            DiagnosisVerdict::missing);
}

TEST(SuspectedFaultTest, RepeatsThatDifferMayBeTheBall) {
  const Observations all = with_second_shot_times(1.0);
  Diagnosis d;
  d.seen = std::make_shared<const Observations>(all);
  d.selection.baseline.fit =
      fit_hypothesis(all, {.believed = testing::believed_law(), .effects = {}});
  d.verdict = DiagnosisVerdict::unexplained;
  d.contradictions = {{.what = "repeat", .of = all.shots[1].label, .measured = 9.0, .error = 1.0}};
  suspect_what_contradicts_momentum(d, all);
  EXPECT_EQ(d.verdict, DiagnosisVerdict::unexplained);
  EXPECT_TRUE(d.withheld.empty()) << d.withheld;
}

TEST(SuspectedFaultTest, CoarseReadingsThatAgreeAreOfTheRecorder) {
  Observations coarse;
  coarse.coarse_step = 24.0;
  Diagnosis d;
  d.seen = std::make_shared<const Observations>(coarse);
  d.verdict = DiagnosisVerdict::unexplained;
  d.believed.p_value = 1e-5;
  suspect_a_coarse_recorder(d, {});
  EXPECT_EQ(d.verdict, DiagnosisVerdict::unexplained);
  d.verdict = DiagnosisVerdict::agrees;
  suspect_a_coarse_recorder(d, {});
  EXPECT_EQ(d.verdict, DiagnosisVerdict::measurement_fault);
  EXPECT_NE(d.fault.find("24 N"), std::string::npos) << d.fault;
}

// A cell of the map that nothing explains, where χ² is that of noise.
TEST(SuspectedFaultTest, CoarseReadingsAreAlikeInNeighbours) {
  Observations seen;
  Diagnosis d;
  d.verdict = DiagnosisVerdict::unexplained;
  d.believed.p_value = 0.9;
  d.seen = std::make_shared<const Observations>(seen);
  suspect_a_coarse_recorder(d, {});
  EXPECT_EQ(d.verdict, DiagnosisVerdict::unexplained);
  seen.coarse_step = 24.0;
  d.seen = std::make_shared<const Observations>(seen);
  suspect_a_coarse_recorder(d, {});
  EXPECT_EQ(d.verdict, DiagnosisVerdict::measurement_fault);
}

TEST(SuspectedFaultTest, AShotThatNoFitSawIsSaidOnlyWhereTheModelAgrees) {
  Diagnosis d;
  d.selection.faults_of_one_shot = {"shot-gain", "odd-shot"};
  d.verdict = DiagnosisVerdict::one_of;
  suspect_a_shot_that_no_fit_saw(d);
  EXPECT_EQ(d.verdict, DiagnosisVerdict::one_of);
  d.verdict = DiagnosisVerdict::agrees;
  suspect_a_shot_that_no_fit_saw(d);
  EXPECT_EQ(d.verdict, DiagnosisVerdict::measurement_fault);
  EXPECT_EQ(d.candidates.size(), 2u);
  Diagnosis nothing;
  nothing.verdict = DiagnosisVerdict::agrees;
  suspect_a_shot_that_no_fit_saw(nothing);
  EXPECT_EQ(nothing.verdict, DiagnosisVerdict::agrees);
}

TEST(SuspectedFaultTest, AnOffsetIsSaidOnlyWhereTheModelAgrees) {
  Observations seen;
  seen.zero_offset = -250.0;
  Diagnosis d;
  d.seen = std::make_shared<const Observations>(seen);
  d.verdict = DiagnosisVerdict::missing;
  suspect_an_offset(d);
  EXPECT_EQ(d.verdict, DiagnosisVerdict::missing);
  d.verdict = DiagnosisVerdict::agrees;
  suspect_an_offset(d);
  EXPECT_EQ(d.verdict, DiagnosisVerdict::measurement_fault);
  EXPECT_NE(d.fault.find("-250 N"), std::string::npos) << d.fault;
}

}  // namespace
}  // namespace rebound
