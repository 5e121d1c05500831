#include "comparisons/discrepancy/synthesis/synthesize.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "comparisons/discrepancy/synthesis/truth.hpp"
#include "comparisons/io/dataset/read_dataset.hpp"
#include "comparisons/io/dataset/write_dataset.hpp"
#include "comparisons/io/results/digest.hpp"
#include "lumped/problem/error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace rebound {
namespace {

SynthesisFile two_shots() {
  SynthesisFile file;
  file.sphere = {.mass = 89.6e-3, .diameter = 66.2e-3};
  file.lumped.parameters = {{"exponent", 1.5}, {"stiffness", 3.5e6}, {"damping", 8e4}};
  file.shots = {{.speed = 5.0}, {.speed = 15.0}};
  return file;
}

Synthesis make(const SynthesisFile& file) {
  return synthesize(file, simulator_of(file, {}));
}

TEST(SynthesizeTest, IdealExperimentIsTheModel) {
  const SynthesisFile file = two_shots();
  const Synthesis made = make(file);
  ASSERT_EQ(made.dataset.shots.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const MeasuredImpact& shot = made.dataset.shots[i];
    const auto& force = shot.trace.force;
    const double peak = *std::max_element(force.begin(), force.end());
    EXPECT_NEAR(peak / made.hidden[i].scalars.peak_force, 1.0, 1e-4);
    double impulse = 0.0;
    for (const double f : force) impulse += f / file.sampling.rate;
    const double momentum =
        file.sphere.mass * (shot.impact.speed + made.hidden[i].scalars.rebound_speed);
    EXPECT_NEAR(impulse / momentum, 1.0, 1e-4);
    EXPECT_EQ(made.hidden[i].speed, shot.impact.speed);
  }
}

TEST(SynthesizeTest, ASeedMeansTheSameWhateverTheOtherShots) {
  SynthesisFile file = two_shots();
  file.instrument.force_noise = 20.0;
  const Synthesis both = make(file);
  EXPECT_EQ(make(file).dataset.shots[1].trace.force, both.dataset.shots[1].trace.force);
  file.shots.pop_back();
  EXPECT_EQ(make(file).dataset.shots[0].trace.force, both.dataset.shots[0].trace.force);
  file.seed = 2;
  EXPECT_NE(make(file).dataset.shots[0].trace.force, both.dataset.shots[0].trace.force);
}

TEST(SynthesizeTest, AFaultOfOneShotLeavesTheOthers) {
  SynthesisFile file = two_shots();
  const Synthesis plain = make(file);
  file.effects = {{"shot-gain", 0.1, {{"shot", 2.0}}}};
  const Synthesis made = make(file);
  EXPECT_EQ(made.dataset.shots[0].trace.force, plain.dataset.shots[0].trace.force);
  const auto& reported = made.dataset.shots[1].trace.force;
  const auto& true_force = plain.dataset.shots[1].trace.force;
  for (std::size_t i = 0; i < reported.size(); ++i)
    EXPECT_NEAR(reported[i], 1.1 * true_force[i], 1e-9 * std::abs(reported[i]));
}

TEST(SynthesizeTest, AStatedBandwidthIsThatOfTheRecord) {
  SynthesisFile file = two_shots();
  const Synthesis plain = make(file);
  file.instrument.force_bandwidth = 300.0;
  const std::vector<double> slow = make(file).dataset.shots[1].trace.force;
  const auto& fast = plain.dataset.shots[1].trace.force;
  EXPECT_LT(*std::max_element(slow.begin(), slow.end()),
            0.99 * *std::max_element(fast.begin(), fast.end()));
  file.instrument.force_bandwidth.reset();
  file.effects = {{"bandwidth", 300.0, {}}};
  EXPECT_EQ(make(file).dataset.shots[1].trace.force, slow) << "an effect says the same";
}

TEST(SynthesizeTest, NoiseHasItsStandardDeviation) {
  SynthesisFile file = two_shots();
  file.instrument.force_noise = 20.0;
  file.sampling.before = 1e-3;
  file.sampling.rate = 2e6;
  const auto force = make(file).dataset.shots[0].trace.force;
  double square = 0.0;
  for (std::size_t i = 0; i < 1900; ++i) square += force[i] * force[i];
  EXPECT_NEAR(std::sqrt(square / 1900.0), 20.0, 1.5);  // 4.5 standard errors
}

// Over many seeds gain, mass and speed scatter as the data set says, which states none of them.
TEST(SynthesizeTest, StatedUncertaintiesAreHonest) {
  double gain = 0.0, mass = 0.0, speed = 0.0;
  SynthesisFile file = two_shots();
  file.shots = {
      {.speed = 5.0, .history = false, .speed_uncertainty = 0.1, .restitution_uncertainty = 0.01}};
  file.instrument.force_gain_uncertainty = 0.03;
  file.mass_uncertainty = 2e-3;
  const int seeds = 400;
  for (file.seed = 0; file.seed < seeds; ++file.seed) {
    const Synthesis made = make(file);
    gain += std::pow(made.true_force_gain, 2) / seeds;
    mass += std::pow(made.true_mass - file.sphere.mass, 2) / seeds;
    speed += std::pow(made.hidden[0].speed - 5.0, 2) / seeds;
    ASSERT_EQ(made.dataset.shots[0].impact.speed, 5.0);
    ASSERT_EQ(made.dataset.sphere.mass, file.sphere.mass);
  }
  // 4.5 standard errors, σ/√(2 seeds) each
  EXPECT_NEAR(std::sqrt(gain), 0.03, 0.0045);
  EXPECT_NEAR(std::sqrt(mass), 2e-3, 3.2e-4);
  EXPECT_NEAR(std::sqrt(speed), 0.1, 0.016);
}

// Reported = (1 + error) true.
TEST(SynthesizeTest, AWrongMassAndAWrongSpeedAreStated) {
  SynthesisFile file = two_shots();
  file.effects = {{"mass", 0.1, {}}, {"speed-calibration", 0.25, {}}};
  const Synthesis made = make(file);
  EXPECT_NEAR(1.1 * made.true_mass, made.dataset.sphere.mass, 1e-15);
  EXPECT_NEAR(1.25 * made.hidden[1].speed, made.dataset.shots[1].impact.speed, 1e-13);
}

TEST(SynthesizeTest, AGainFaultScalesTheForce) {
  SynthesisFile file = two_shots();
  const auto plain = make(file).dataset.shots[0].trace.force;
  file.effects = {{.name = "force-gain", .size = 0.1, .parameters = {}}};
  const auto scaled = make(file).dataset.shots[0].trace.force;
  for (std::size_t i = 0; i < plain.size(); ++i) EXPECT_NEAR(scaled[i], 1.1 * plain[i], 1e-9);
}

TEST(SynthesizeTest, AMovingPlateGoesOnRinging) {
  SynthesisFile file = two_shots();
  file.effects = {{.name = "plate-compliance", .size = 2e-8, .parameters = {}}};
  const auto trace = make(file).dataset.shots[0].trace;
  EXPECT_GT(std::abs(trace.force[trace.force.size() - 10]), 50.0);
}

TEST(SynthesizeTest, TooLowASamplingRateIsRefused) {
  SynthesisFile file = two_shots();
  file.sampling.rate = 1e3;
  EXPECT_THROW(make(file), Error);
}

TEST(WriteDatasetTest, RoundTrip) {
  SynthesisFile file = two_shots();
  file.instrument.force_noise = 20.0;
  file.mass_uncertainty = 1e-4;
  const Dataset made = make(file).dataset;
  const testing::TemporaryFolder folder;
  write_dataset(made, folder.path() / "data");
  const Dataset read = read_dataset(folder.path() / "data");
  ASSERT_EQ(read.shots.size(), made.shots.size());
  EXPECT_EQ(read.shots[1].trace.force, made.shots[1].trace.force);
  EXPECT_EQ(read.sphere.mass, made.sphere.mass);
  EXPECT_EQ(read.mass_uncertainty, made.mass_uncertainty);
  EXPECT_TRUE(read.shots[0].trace.deflection.empty());
}

TEST(TruthTest, ASealHoldsTheTruthsBytesAndCannotBeGuessed) {
  const SynthesisFile file = two_shots();
  const Json truth = truth_json(file, "text", make(file));
  const SealedTruth one = seal(truth), other = seal(truth);
  EXPECT_EQ(Json::parse(one.seal)["sha256"], sha256(one.truth));
  EXPECT_NE(one.truth, other.truth);
  EXPECT_EQ(Json::parse(one.truth)["nonce"].get<std::string>().size(), 64u);
}

/// Differences of one record from the ideal one.
std::vector<double> noise_of(const SynthesisFile& file) {
  SynthesisFile quiet = file;
  quiet.instrument.force_noise.reset();
  std::vector<double> noise = make(file).dataset.shots[0].trace.force;
  const auto ideal = make(quiet).dataset.shots[0].trace.force;
  for (std::size_t i = 0; i < noise.size(); ++i) noise[i] -= ideal[i];
  return noise;
}

double correlation_of_neighbours(const std::vector<double>& noise) {
  double product = 0.0, square = 0.0;
  for (std::size_t i = 1; i < noise.size(); ++i) {
    product += noise[i] * noise[i - 1];
    square += noise[i] * noise[i];
  }
  return product / square;
}

TEST(SynthesizeTest, NoiseIsWhiteOrHasItsTime) {
  SynthesisFile file = two_shots();
  file.sampling = {.rate = 1e6, .before = 1e-3, .after = 1e-3};
  file.instrument.force_noise = 10.0;
  EXPECT_NEAR(correlation_of_neighbours(noise_of(file)), 0.0, 0.06);
  file.instrument.noise_correlation_time = 5e-6;
  const auto coloured = noise_of(file);
  EXPECT_NEAR(correlation_of_neighbours(coloured), std::exp(-0.2), 0.06);
  double square = 0.0;
  for (const double value : coloured) square += value * value;
  EXPECT_NEAR(std::sqrt(square / static_cast<double>(coloured.size())), 10.0, 1.5);
}

TEST(SynthesizeTest, TheTriggerJitters) {
  SynthesisFile file = two_shots();
  file.shots = {{.speed = 15.0, .repeats = 40}};
  file.sampling.trigger_jitter = 50e-6;
  double sum = 0.0, squares = 0.0;
  const Synthesis made = make(file);
  for (const MeasuredImpact& shot : made.dataset.shots) {
    const auto& force = shot.trace.force;
    const auto first = std::find_if(force.begin(), force.end(), [](double f) { return f > 20.0; });
    const double touch = shot.trace.time[static_cast<std::size_t>(first - force.begin())];
    sum += touch;
    squares += touch * touch;
  }
  const double mean = sum / 40.0;
  EXPECT_NEAR(std::sqrt(squares / 40.0 - mean * mean), 50e-6, 20e-6);
}

TEST(SynthesizeTest, ACameraCountsFrames) {
  SynthesisFile file = two_shots();
  file.instrument.camera_rate = 4000.0;
  file.shots = {{.speed = 15.0, .repeats = 30, .contact_time_uncertainty = 1e-9}};
  const Synthesis made = make(file);
  double sum = 0.0;
  for (const MeasuredImpact& shot : made.dataset.shots) {
    const double frames = *shot.contact_time.value * 4000.0;
    EXPECT_NEAR(frames, std::round(frames), 1e-3);
    EXPECT_NEAR(*shot.contact_time.uncertainty, 1.0 / (std::sqrt(6.0) * 4000.0), 1e-8);
    sum += *shot.contact_time.value;
  }
  EXPECT_NEAR(sum / 30.0, made.hidden[0].scalars.contact_time, 0.1e-3);  // no bias
}

}  // namespace
}  // namespace rebound
