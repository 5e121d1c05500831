// Records that are no clean impact: the right verdict or a clear word, never a confident name.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "comparisons/discrepancy/diagnosis/verdict/verdict.hpp"
#include "lumped/problem/error.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

using testing::believed_law;
using testing::diagnosis_of;
using testing::experiment_with;

Dataset null_data(std::int64_t seed) {
  return testing::measured_data(experiment_with({}, seed));
}

bool names_physics(const Diagnosis& d) {
  const bool names = d.verdict == DiagnosisVerdict::missing;
  return names && std::any_of(d.effects.begin(), d.effects.end(), [](const NamedEffect& one) {
           return !is_measurement(one.effect.name);
         });
}

bool says(const Diagnosis& d, const std::string& words) {
  return std::any_of(d.warnings.begin(), d.warnings.end(), [&](const std::string& warning) {
    return warning.find(words) != std::string::npos;
  });
}

/// Keeps the samples for which `keep` says yes, by their index and that of the peak.
void keep_samples(Trace& trace, const std::function<bool(std::size_t, std::size_t)>& keep) {
  const auto peak = static_cast<std::size_t>(
      std::max_element(trace.force.begin(), trace.force.end()) - trace.force.begin());
  Trace kept;
  for (std::size_t i = 0; i < trace.time.size(); ++i)
    if (keep(i, peak)) {
      kept.time.push_back(trace.time[i]);
      kept.force.push_back(trace.force[i]);
    }
  trace = kept;
}

struct Defect {
  const char* name;
  std::function<void(Trace&)> make;
  const char* said;
};

class DefectiveRecord : public ::testing::TestWithParam<Defect> {};

// One of three records is spoilt: it is left out, with a word, and the others agree.
TEST_P(DefectiveRecord, IsLeftOutAndSaid) {
  for (const int seed : {41, 42, 43}) {
    Dataset dataset = null_data(seed);
    GetParam().make(dataset.shots[2].trace);
    const Diagnosis d = diagnosis_of(dataset);
    EXPECT_TRUE(says(d, GetParam().said)) << GetParam().said;
    EXPECT_EQ(d.verdict, DiagnosisVerdict::agrees);
  }
}

void add_second_impact(Trace& trace) {
  const Trace first = trace;
  const double later = first.time.back() - first.time.front() + first.time[1] - first.time[0];
  for (std::size_t i = 0; i < first.time.size(); ++i) {
    trace.time.push_back(first.time[i] + later);
    trace.force.push_back(0.6 * first.force[i]);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Every, DefectiveRecord,
    ::testing::Values(Defect{"CutInTheContact",
                             [](Trace& trace) {
                               keep_samples(trace, [](std::size_t i, std::size_t peak) {
                                 return i < peak + 30;
                               });
                             },
                             "is cut in the contact"},
                      Defect{"StartsLate",
                             [](Trace& trace) {
                               keep_samples(trace, [](std::size_t i, std::size_t peak) {
                                 return i + 40 > peak;
                               });
                             },
                             "starts in the contact"},
                      Defect{"HasAGap",
                             [](Trace& trace) {
                               keep_samples(trace, [](std::size_t i, std::size_t peak) {
                                 return i < peak + 5 || i > peak + 30;
                               });
                             },
                             "has a gap of"},
                      Defect{"HoldsTwoImpacts", add_second_impact, "holds a second impact"}),
    [](const auto& instance) { return std::string(instance.param.name); });

TEST(BadRecordsTest, WithoutAWholeRecordThereIsNotEnoughData) {
  Dataset dataset = null_data(44);
  for (MeasuredImpact& shot : dataset.shots) {
    shot.restitution = {};
    keep_samples(shot.trace, [](std::size_t i, std::size_t peak) { return i < peak; });
  }
  const Diagnosis d = diagnosis_of(dataset);
  EXPECT_EQ(d.verdict, DiagnosisVerdict::insufficient_data);
  EXPECT_TRUE(says(d, "is cut in the contact"));
}

TEST(BadRecordsTest, ARecordThatClipsIsAFaultOrUnnamed) {
  for (const int seed : {45, 46}) {
    Dataset dataset = null_data(seed);
    for (MeasuredImpact& shot : dataset.shots)
      for (double& force : shot.trace.force) force = std::min(force, 4000.0);
    const Diagnosis d = diagnosis_of(dataset);
    EXPECT_FALSE(names_physics(d)) << d.effects.front().effect.name;
    EXPECT_NE(d.verdict, DiagnosisVerdict::agrees);
  }
}

TEST(BadRecordsTest, ShotsThatContradictEachOtherNameNoPhysics) {
  for (const int seed : {47, 48}) {
    Dataset dataset = null_data(seed);
    dataset.shots.push_back(dataset.shots[1]);
    for (double& force : dataset.shots.back().trace.force) force *= 1.2;
    const Diagnosis d = diagnosis_of(dataset);
    EXPECT_FALSE(names_physics(d)) << d.effects.front().effect.name;
    EXPECT_NE(d.verdict, DiagnosisVerdict::agrees);  // held out as they are, they are looked at
  }
}

TEST(BadRecordsTest, OneSpeedCarriesNoName) {
  for (const double size : {0.0, 0.4}) {
    SynthesisFile file = experiment_with({}, 49);
    if (size > 0.0) file.effects = {{"hysteresis", size, {}}};
    file.shots = {file.shots[1], file.shots[1], file.shots[1]};
    const Diagnosis d = diagnosis_of(synthesize(file, simulator_of(file, {})).dataset);
    EXPECT_NE(d.verdict, DiagnosisVerdict::missing);
    if (size == 0.0) {
      EXPECT_EQ(d.verdict, DiagnosisVerdict::agrees);
    }
  }
}

TEST(BadRecordsTest, ARestitutionAboveOneIsNoPhysics) {
  Dataset dataset = null_data(50);
  for (MeasuredImpact& shot : dataset.shots) shot.restitution = {.value = 1.1, .uncertainty = 0.01};
  try {
    const Diagnosis d = diagnosis_of(dataset);
    EXPECT_FALSE(names_physics(d)) << d.effects.front().effect.name;
    EXPECT_NE(d.verdict, DiagnosisVerdict::agrees);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::bad_input);
  }
}

// A stiffness ten thousand times too small is out of every search's reach.
TEST(BadRecordsTest, ABelievedModelThatCannotBeFittedNamesNothing) {
  DiagnosisRequest request;
  request.datasets = {null_data(51)};
  request.believed = believed_law();
  request.believed.parameters["stiffness"] = 3.5e2;
  request.ask_fem = false;
  try {
    const Diagnosis d = diagnose(request);
    EXPECT_FALSE(names_physics(d)) << d.effects.front().effect.name;
  } catch (const Error& error) {
    EXPECT_TRUE(error.code() == ExitCode::bad_input || error.code() == ExitCode::solver_failed);
  }
}

TEST(BadRecordsTest, WithoutAnyNoiseThereIsNotEnoughData) {
  SynthesisFile file = experiment_with({{"hysteresis", 0.4, {}}}, 52);
  file.sampling.before = 0.0;
  Dataset dataset = synthesize(file, simulator_of(file, {})).dataset;
  dataset.instrument.force_noise.reset();
  for (MeasuredImpact& shot : dataset.shots) shot.restitution.uncertainty.reset();
  const Diagnosis d = diagnosis_of(dataset);
  EXPECT_EQ(d.verdict, DiagnosisVerdict::insufficient_data);
  EXPECT_TRUE(d.effects.empty());
  EXPECT_FALSE(d.needed.empty());
}

// The same data and fits, once as they came out and once with the size where the search ends.
TEST(BadRecordsTest, AnEffectAtItsBoundCarriesNoName) {
  Diagnosis d = testing::diagnose_hidden(experiment_with({{"hysteresis", 0.4, {}}}, 53));
  ASSERT_EQ(d.verdict, DiagnosisVerdict::missing);
  HypothesisFit& fit = d.selection.tried[d.selection.indistinguishable.front()].fit;
  for (const std::size_t unknown : fit.model->unknowns_of_effect(0))
    fit.search.estimates[unknown].identifiability = Identifiability::at_bound;
  d.candidates.clear();
  d.effects.clear();
  d.curves.clear();
  conclude(d, {});
  EXPECT_EQ(d.verdict, DiagnosisVerdict::family);
  EXPECT_TRUE(d.effects.empty());
  EXPECT_NE(d.withheld.find("at a bound of the search"), std::string::npos) << d.withheld;
}

}  // namespace
}  // namespace rebound
