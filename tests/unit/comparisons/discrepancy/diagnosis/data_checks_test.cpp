// Data that contradict themselves, and data that do not.
#include "comparisons/discrepancy/diagnosis/data_checks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "comparisons/discrepancy/diagnosis/noise_source.hpp"
#include "comparisons/discrepancy/diagnosis/observe.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

/// Three speeds, twice each, every instrument there is.
SynthesisFile laboratory(std::int64_t seed) {
  SynthesisFile file = testing::experiment_with({}, seed);
  file.instrument.deflection = DeflectionOrigin::independent;
  file.instrument.deflection_noise = 2e-5;
  file.instrument.deflection_gain_uncertainty = 0.01;
  file.instrument.contact_threshold = 100.0;
  for (SynthesisShot& shot : file.shots) {
    shot.repeats = 2;
    shot.restitution_uncertainty = 0.01;
    shot.contact_time_uncertainty = 1e-5;
  }
  return file;
}

Dataset made(const SynthesisFile& file) {
  return synthesize(file, simulator_of(file, {})).dataset;
}

std::vector<DataCheck> contradictions_of(const Dataset& dataset) {
  return contradictions_among(check_data(observe({dataset})));
}

bool shows(const std::vector<DataCheck>& found, const std::string& what) {
  return std::any_of(found.begin(), found.end(),
                     [&](const DataCheck& check) { return check.what == what; });
}

void scale_force(MeasuredImpact& shot, double factor) {
  for (double& force : shot.trace.force) force *= factor;
}

struct Noise {
  const char* name;
  std::vector<double> autocorrelation;
};

class DataChecksTest : public ::testing::TestWithParam<Noise> {};

// One data set in fifty at most: the checks are meant for one in two hundred.
TEST_P(DataChecksTest, DataWithoutAFaultShowNone) {
  int alarms = 0;
  for (int seed = 1; seed <= 100; ++seed) {
    SynthesisFile file = laboratory(seed);
    file.instrument.force_noise = 0.0;
    Dataset dataset = made(file);
    dataset.instrument.force_noise = 20.0;
    NoiseSource noise({.deviation = 20.0, .autocorrelation = GetParam().autocorrelation},
                      static_cast<std::uint64_t>(seed));
    for (MeasuredImpact& shot : dataset.shots) shot.trace.force = noise.added_to(shot.trace.force);
    alarms += contradictions_of(dataset).empty() ? 0 : 1;
  }
  EXPECT_LE(alarms, 2);
}

INSTANTIATE_TEST_SUITE_P(Noises, DataChecksTest,
                         ::testing::Values(Noise{"White", {}}, Noise{"Coloured", {0.7}}),
                         [](const auto& instance) { return std::string(instance.param.name); });

struct Fault {
  const char* name;
  std::function<void(Dataset&)> make;
  const char* shown_by;
};

class DataFault : public ::testing::TestWithParam<Fault> {};

// Nine of ten data sets at least.
TEST_P(DataFault, IsShown) {
  int shown = 0;
  constexpr int seeds = 10;
  for (int seed = 1; seed <= seeds; ++seed) {
    Dataset dataset = made(laboratory(300 + seed));
    GetParam().make(dataset);
    shown += shows(contradictions_of(dataset), GetParam().shown_by) ? 1 : 0;
  }
  EXPECT_GE(shown, 9);
}

INSTANTIATE_TEST_SUITE_P(
    Faults, DataFault,
    ::testing::Values(
        Fault{"GainOfAll",
              [](Dataset& d) {
                for (auto& shot : d.shots) scale_force(shot, 1.1);
              },
              "impulse"},
        Fault{"GainOfOne", [](Dataset& d) { scale_force(d.shots[2], 1.1); }, "restitution"},
        Fault{"GainOfOneAmongRepeats", [](Dataset& d) { scale_force(d.shots[2], 1.1); }, "repeat"},
        Fault{"MassAgainstDeflection", [](Dataset& d) { d.sphere.mass *= 1.1; },
              "force-over-inertia"},
        Fault{"RestitutionAboveOne",
              [](Dataset& d) { d.shots[0].restitution = {.value = 1.1, .uncertainty = 0.01}; },
              "restitution-range"},
        Fault{"ImpulseAboveTwo",
              [](Dataset& d) {
                for (auto& shot : d.shots) scale_force(shot, 1.6);
              },
              "restitution-range"},
        Fault{"EnergyOfALateDeflection",
              [](Dataset& d) {
                for (auto& shot : d.shots) {
                  auto& x = shot.trace.deflection;
                  std::rotate(x.begin(), x.end() - 12, x.end());
                }
              },
              "energy"},
        Fault{"ContactTime", [](Dataset& d) { *d.shots[4].contact_time.value *= 1.1; },
              "contact-time"},
        Fault{"PeakForce",
              [](Dataset& d) {
                const auto& force = d.shots[4].trace.force;
                const double peak = *std::max_element(force.begin(), force.end());
                d.shots[4].peak_force = {.value = 1.1 * peak, .uncertainty = 0.01 * peak};
              },
              "peak-force"},
        Fault{"SpeedAgainstDeflection", [](Dataset& d) { d.shots[3].impact.speed *= 1.07; },
              "approach-speed"}),
    [](const auto& instance) { return std::string(instance.param.name); });

TEST(DataChecksOfOrderTest, AGainThatDriftsFromShotToShotIsShown) {
  int shown = 0;
  for (int seed = 1; seed <= 10; ++seed) {
    SynthesisFile file = testing::experiment_with({}, 400 + seed);
    for (SynthesisShot& shot : file.shots) shot.repeats = 4;
    Dataset dataset = made(file);
    for (std::size_t i = 0; i < dataset.shots.size(); ++i)
      scale_force(dataset.shots[i], 1.0 + 0.02 * static_cast<double>(i));
    const auto found = contradictions_of(dataset);
    shown += shows(found, "order") ? 1 : 0;
  }
  EXPECT_GE(shown, 9);
}

TEST(DataChecksRemedyTest, SaysByHowMuchAGainIsWrong) {
  Dataset dataset = made(laboratory(77));
  for (MeasuredImpact& shot : dataset.shots) scale_force(shot, 1.1);
  const auto found = contradictions_of(dataset);
  const auto impulse = std::find_if(found.begin(), found.end(),
                                    [](const DataCheck& one) { return one.what == "impulse"; });
  ASSERT_NE(impulse, found.end());
  EXPECT_NEAR(impulse->measured, 1.1, 4.0 * impulse->error);
  EXPECT_NE(impulse->mended_by.find("force gain"), std::string::npos);
}

TEST(ContradictionLimitTest, GrowsWithTheNumberOfChecks) {
  EXPECT_EQ(contradiction_limit(1), 4.0);
  EXPECT_GT(contradiction_limit(1000), 4.0);
}

}  // namespace
}  // namespace rebound
