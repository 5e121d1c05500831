// Faults of the measuring chain are hidden in lumped data of three speeds. How often does the
// diagnosis call them faults of the measurement, with the one that was hidden in its set?
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

using testing::diagnose_hidden;
using testing::experiment_with;
using testing::three_times_each_speed;

constexpr int seeds = 5;

bool names(const Diagnosis& d, const std::string& fault) {
  return std::any_of(d.candidates.begin(), d.candidates.end(), [&](const auto& set) {
    return std::find(set.begin(), set.end(), fault) != set.end();
  });
}

struct HiddenFault {
  const char* title;
  EffectChoice effect;
  int recognised = seeds;  ///< at least, of five seeds
};

class MeasurementFault : public ::testing::TestWithParam<HiddenFault> {};

TEST_P(MeasurementFault, IsRecognisedAsWhatItIs) {
  const EffectChoice& hidden = GetParam().effect;
  int recognised = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    const Diagnosis d = diagnose_hidden(experiment_with({hidden}, seed));
    const bool is_fault = d.verdict == DiagnosisVerdict::measurement_fault;
    if (is_fault && names(d, hidden.name)) ++recognised;
    std::string said = std::string(name_of(d.verdict)) + ":";
    for (const auto& set : d.candidates) {
      for (const auto& name : set) said += " " + name;
      said += ";";
    }
    RecordProperty("seed_" + std::to_string(seed), said);
  }
  RecordProperty("recognised", recognised);
  EXPECT_GE(recognised, GetParam().recognised);
}

INSTANTIATE_TEST_SUITE_P(
    Lumped, MeasurementFault,
    ::testing::Values(
        HiddenFault{"drift", {"force-drift", 6e4, {}}}, HiddenFault{"droop", {"droop", 60.0, {}}},
        HiddenFault{"hum", {"hum", 80.0, {{"frequency", 1150.0}, {"phase", 2.0}}}},
        HiddenFault{"slow_hum", {"hum", 80.0, {{"frequency", 350.0}, {"phase", 2.0}}}},
        HiddenFault{
            "burst",
            {"burst", 250.0, {{"frequency", 4e3}, {"decay_time", 0.4e-3}, {"instant", 0.7e-3}}}},
        HiddenFault{"time_base", {"time-base", 0.08, {}}},
        HiddenFault{"clipping", {"clipping", 4.2e3, {}}},
        HiddenFault{"shot_gain", {"shot-gain", -0.12, {{"shot", 3.0}}}},
        HiddenFault{"shot_speed", {"shot-speed", 0.08, {{"shot", 1.0}}}}),
    [](const auto& parameter) { return parameter.param.title; });

TEST(MeasurementFaultTest, TheNumbersOfAHumAreFound) {
  const EffectChoice hidden{"hum", 80.0, {{"frequency", 1150.0}, {"phase", 2.0}}};
  const Diagnosis d = diagnose_hidden(experiment_with({hidden}, 1));
  ASSERT_EQ(d.effects.size(), 1u);
  ASSERT_EQ(d.effects[0].parameters.size(), 2u);
  EXPECT_NEAR(d.effects[0].parameters[0].value, 1150.0, 60.0);
  // A phase has an interval about itself, below zero too: it is no logarithm.
  const NumberWithInterval& phase = d.effects[0].parameters[1];
  EXPECT_LT(phase.low, phase.value);
  EXPECT_GT(phase.high, phase.value);
  EXPECT_LT(phase.high - phase.low, 1.0);
}

TEST(MeasurementFaultTest, TheShotIsNamed) {
  const EffectChoice hidden{"shot-gain", -0.12, {{"shot", 3.0}}};
  const Diagnosis d = diagnose_hidden(experiment_with({hidden}, 1));
  ASSERT_FALSE(d.selection.indistinguishable.empty());
  for (const std::size_t i : d.selection.indistinguishable)
    for (const EffectChoice& effect : d.selection.tried[i].fit.effects)
      if (effect.name == "shot-gain") {
        EXPECT_EQ(effect.parameters.at("shot"), 3.0);
      }
}

// With one shot a speed it is as well a stiffness that follows the speed.
TEST(MeasurementFaultTest, AnOddShotAmongRepeatsIsRecognised) {
  const EffectChoice hidden{"odd-shot", -0.1, {{"shot", 4.0}, {"time_exponent", -1.0}}};
  for (int seed = 1; seed <= seeds; ++seed) {
    const Diagnosis d = diagnose_hidden(three_times_each_speed({hidden}, seed));
    EXPECT_EQ(d.verdict, DiagnosisVerdict::measurement_fault);
    EXPECT_TRUE(names(d, hidden.name)) << d.fault;
  }
}

/// No fit sees the shots at 15 m/s: their repeats contradict the odd one.
TEST(MeasurementFaultTest, AnOddShotAtTheUnseenSpeedIsRecognised) {
  const EffectChoice hidden{"odd-shot", -0.1, {{"shot", 5.0}, {"time_exponent", -1.0}}};
  for (int seed = 1; seed <= seeds; ++seed) {
    const Diagnosis d = diagnose_hidden(three_times_each_speed({hidden}, seed));
    EXPECT_EQ(d.verdict, DiagnosisVerdict::measurement_fault);
    EXPECT_NE(d.fault.find("odd-shot (shot 5"), std::string::npos) << d.fault;
  }
}

TEST(MeasurementFaultTest, AStatedBandwidthIsNoFault) {
  int gaps = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    SynthesisFile file = experiment_with({}, seed);
    file.instrument.force_bandwidth = 3e3;
    if (diagnose_hidden(file).verdict != DiagnosisVerdict::agrees) ++gaps;
  }
  EXPECT_LE(gaps, 1);
}

TEST(MeasurementFaultTest, ABandwidthBeyondTheRecordIsNoMatter) {
  SynthesisFile file = experiment_with({}, 1);
  file.instrument.force_bandwidth = 1e6;
  EXPECT_EQ(diagnose_hidden(file).verdict, DiagnosisVerdict::agrees);
}

// Rounding by more than the noise is told by the readings; within it the model agrees.
TEST(MeasurementFaultTest, ACoarseRecorderIsRecognised) {
  for (int seed = 1; seed <= seeds; ++seed) {
    const Diagnosis d = diagnose_hidden(experiment_with({{"quantisation", 200.0, {}}}, seed));
    EXPECT_EQ(d.verdict, DiagnosisVerdict::measurement_fault);
    EXPECT_NE(d.fault.find("quantisation"), std::string::npos) << d.fault;
  }
}

TEST(MeasurementFaultTest, AFineRecorderIsNone) {
  const Diagnosis d = diagnose_hidden(experiment_with({{"quantisation", 20.0, {}}}, 1));
  EXPECT_EQ(d.verdict, DiagnosisVerdict::agrees);
}

}  // namespace
}  // namespace rebound
