#include "comparisons/discrepancy/inspection/inspection.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "comparisons/discrepancy/inspection/inspection_output.hpp"
#include "comparisons/io/report/check.hpp"
#include "tests/support/gaussian_noise.hpp"

namespace rebound {
namespace {

struct Recording {
  double speed = 10.0, restitution = 0.55, contact = 2e-3, interval = 5e-6, noise = 4.0;
  double gain = 1.0, colour = 0.0, before = 2e-3;
  std::uint64_t seed = 1;
};

constexpr double mass = 0.0896;

double peak_of(const Recording& r) {
  return r.gain * mass * r.speed * (1.0 + r.restitution) * std::numbers::pi / 2.0 / r.contact;
}

/// A half sine of the right impulse, with noise of the first order.
MeasuredImpact recorded(const Recording& r) {
  MeasuredImpact shot;
  shot.impact.speed = r.speed;
  shot.speed_uncertainty = 0.005 * r.speed;
  shot.restitution = {.value = r.restitution, .uncertainty = 0.005};
  test::GaussianNoise draw(r.seed);
  double noise = 0.0;
  for (double t = -r.before; t < 3.0 * r.contact; t += r.interval) {
    noise = r.colour * noise + std::sqrt(1.0 - r.colour * r.colour) * draw();
    shot.trace.time.push_back(t);
    const bool in = t > 0.0 && t < r.contact;
    shot.trace.force.push_back(
        (in ? peak_of(r) * std::sin(std::numbers::pi * t / r.contact) : 0.0) + r.noise * noise);
  }
  return shot;
}

Dataset dataset_of(const std::vector<Recording>& recordings) {
  Dataset dataset;
  dataset.name = "half sines";
  dataset.sphere = {.mass = mass, .diameter = 0.0662};
  dataset.instrument.force_gain_uncertainty = 0.005;
  for (const Recording& r : recordings) dataset.shots.push_back(recorded(r));
  return dataset;
}

const InspectedNumber& number(const InspectedShot& shot, const std::string& key) {
  for (const InspectedNumber& one : shot.numbers)
    if (one.key == key) return one;
  throw std::runtime_error("no " + key);
}

TEST(InspectionTest, NumbersOfAHalfSineAreItsClosedForms) {
  const Recording r;
  const Inspection found = inspect(dataset_of({r}));
  const InspectedShot& shot = found.shots.front();
  const auto expect = [&](const char* key, double value) {
    const InspectedNumber& one = number(shot, key);
    ASSERT_TRUE(one.uncertainty);
    EXPECT_NEAR(one.value, value, 4.0 * *one.uncertainty) << key;
    EXPECT_LT(*one.uncertainty, 0.05 * value) << key;
  };
  expect("peak_force_N", peak_of(r));
  expect("impulse_N_s", mass * r.speed * (1.0 + r.restitution));
  expect("restitution_from_impulse", r.restitution);
  expect("width_at_three_tenths_s", r.contact * (1.0 - 2.0 * std::asin(0.3) / std::numbers::pi));
  EXPECT_TRUE(found.contradictions.empty());
  EXPECT_NEAR(found.noise.deviation, r.noise, 0.6);
  EXPECT_TRUE(found.noise.autocorrelation.empty());
  EXPECT_TRUE(shot.too_coarse.empty());
}

// 1 + e is the impulse over m v: an error of the gain is one of it, in proportion.
TEST(InspectionTest, TheErrorOfTheGainIsInTheRestitution) {
  const auto variance_with = [](double gain) {
    Dataset dataset = dataset_of({{}});
    dataset.instrument.force_gain_uncertainty = gain;
    const Inspection found = inspect(dataset);
    return std::pow(*number(found.shots.front(), "restitution_from_impulse").uncertainty, 2);
  };
  EXPECT_NEAR(std::sqrt(variance_with(0.05) - variance_with(1e-6)) / (1.55 * 0.05), 1.0, 0.02);
}

// The highest of noisy samples lies beside the peak; the parabola through the top does not.
TEST(InspectionTest, NoiseDoesNotMoveAPeakThatNoFilterLowers) {
  double sum = 0.0;
  constexpr int seeds = 20;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const Inspection found = inspect(dataset_of({{.contact = 8e-3, .noise = 20.0, .seed = seed}}));
    sum += found.shots.front().filters.back().change / seeds;
  }
  EXPECT_NEAR(sum, 0.0, 0.003);
}

TEST(InspectionTest, TheColourOfTheNoiseIsSeen) {
  const Inspection found = inspect(dataset_of({{.colour = 0.7}, {.colour = 0.7, .seed = 2}}));
  ASSERT_FALSE(found.noise.autocorrelation.empty());
  EXPECT_NEAR(found.noise.autocorrelation.front(), 0.7, 0.1);
}

TEST(InspectionTest, AWrongGainContradictsTheSpeeds) {
  const Inspection found =
      inspect(dataset_of({{.gain = 1.1}, {.speed = 15.0, .gain = 1.1, .seed = 2}}));
  ASSERT_FALSE(found.contradictions.empty());
  EXPECT_EQ(found.contradictions.front().what, "impulse");
  EXPECT_NEAR(found.contradictions.front().measured, 1.1, 0.02);
}

TEST(InspectionTest, WhatIsTooCoarseIsSaid) {
  const auto words = [](const Recording& r) {
    std::string text;
    const Inspection found = inspect(dataset_of({r}));
    for (const std::string& why : found.shots.front().too_coarse) text += why + "; ";
    return text;
  };
  EXPECT_NE(words({.interval = 2e-4}).find("samples in contact"), std::string::npos);
  EXPECT_NE(words({.before = 5e-5}).find("before contact"), std::string::npos);
  EXPECT_NE(words({.noise = 100.0}).find("noise"), std::string::npos);
  EXPECT_EQ(words({}), "");
}

TEST(InspectionTest, AFilterOfALowClassLowersThePeakAsItsFormulaSays) {
  const Inspection found = inspect(dataset_of({{.noise = 0.5}}));
  const auto& filters = found.shots.front().filters;
  ASSERT_EQ(filters.size(), 4u);
  EXPECT_LT(filters[0].change, -0.5);
  EXPECT_LT(std::abs(filters[3].change), 0.01);
  for (std::size_t i = 1; i < filters.size(); ++i)
    EXPECT_GT(filters[i].change, filters[i - 1].change);
}

TEST(InspectionTest, ARestitutionOffTheLineOfItsNeighboursIsAContradiction) {
  Dataset dataset = dataset_of({});
  for (int i = 0; i < 7; ++i) {
    MeasuredImpact shot;
    shot.impact.speed = 5.0 + 2.0 * i;
    shot.restitution = {.value = 0.6 - 0.01 * i + (i == 3 ? 0.08 : 0.0), .uncertainty = 0.004};
    dataset.shots.push_back(shot);
  }
  const Inspection found = inspect(dataset);
  ASSERT_EQ(found.contradictions.size(), 1u);
  EXPECT_EQ(found.contradictions.front().what, "restitution-over-speed");
  EXPECT_NE(found.contradictions.front().of.find("11 m/s"), std::string::npos);
}

TEST(InspectionTest, AHundredShotsAreInspectedTogether) {
  std::vector<Recording> recordings;
  for (int i = 0; i < 100; ++i)
    recordings.push_back({.speed = 5.0 + i / 25, .seed = static_cast<std::uint64_t>(i + 1)});
  const Dataset dataset = dataset_of(recordings);
  const Inspection found = inspect(dataset);
  EXPECT_EQ(found.shots.size(), 100u);
  EXPECT_FALSE(found.repeats.empty());
  report::check_report(inspection_report(found, dataset));
}

}  // namespace
}  // namespace rebound
