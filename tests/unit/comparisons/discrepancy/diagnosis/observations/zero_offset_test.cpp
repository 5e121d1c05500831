// Offsets as large as a contact, and what is none.
#include "comparisons/discrepancy/diagnosis/observations/zero_offset.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"
#include "comparisons/discrepancy/inspection/inspection.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

/// Half a sine of 200 samples and height 1000 on a level, with quiet on both sides and noise of 5.
std::vector<double> half_sine(double level, std::size_t quiet) {
  constexpr std::size_t contact = 200;
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, 5.0);
  std::vector<double> force;
  for (std::size_t i = 0; i < contact + 2 * quiet; ++i) {
    const double phase = (static_cast<double>(i) - static_cast<double>(quiet)) / contact;
    force.push_back(level + noise(random) +
                    1000.0 * std::sin(std::numbers::pi * std::clamp(phase, 0.0, 1.0)));
  }
  return force;
}

TEST(ZeroOffsetTest, TheLevelIsThatOfTheQuiet) {
  for (const double level : {-2000.0, -300.0, 0.0, 80.0, 5000.0})
    EXPECT_NEAR(level_of(half_sine(level, 40)), level, 5.0);
}

TEST(ZeroOffsetTest, ACutContactHasNoLevel) {
  for (const std::ptrdiff_t cut : {10, 20, 40, 70}) {
    const std::vector<double> whole = half_sine(0.0, 0);
    EXPECT_EQ(level_of({whole.begin() + cut, whole.end() - cut}), 0.0) << cut;
    EXPECT_EQ(level_of({whole.begin() + cut, whole.end()}), 0.0) << cut;
  }
}

TEST(ZeroOffsetTest, ASmallOneStays) {
  std::vector<MeasuredImpact> shots(1);
  shots[0].trace.force = half_sine(30.0, 40);
  shots[0].trace.time = shots[0].trace.force;
  const std::vector<double> before = shots[0].trace.force;
  EXPECT_EQ(take_out_zero_offset(shots), 0.0);
  EXPECT_EQ(shots[0].trace.force, before);
}

/// The slowest shot of a sound ball rises by less than the offset: no reading is above zero.
Dataset far_below_zero() {
  const SynthesisFile file = testing::experiment_with({}, 3);
  Dataset dataset = synthesize(file, simulator_of(file, {})).dataset;
  double least = 1e300;
  for (const MeasuredImpact& shot : dataset.shots)
    least = std::min(least, *std::max_element(shot.trace.force.begin(), shot.trace.force.end()));
  for (MeasuredImpact& shot : dataset.shots)
    for (double& force : shot.trace.force) force -= 1.2 * least;
  return dataset;
}

TEST(ZeroOffsetTest, IsSaidWhereTheRestAgrees) {
  const Diagnosis d =
      diagnose({.datasets = {far_below_zero()}, .believed = testing::believed_law()});
  EXPECT_EQ(d.verdict, DiagnosisVerdict::measurement_fault);
  EXPECT_EQ(d.candidates, (std::vector<std::vector<std::string>>{{"force-baseline"}}));
  EXPECT_NE(d.fault.find("before and after contact"), std::string::npos) << d.fault;
}

TEST(ZeroOffsetTest, IsNoObstacleToALookAtTheData) {
  const Inspection found = inspect(far_below_zero());
  ASSERT_FALSE(found.shots.empty());
  for (const InspectedShot& shot : found.shots) EXPECT_GT(shot.samples_in_contact, 20U);
  EXPECT_TRUE(std::any_of(found.warnings.begin(), found.warnings.end(), [](const auto& warning) {
    return warning.find("taken out of every shot") != std::string::npos;
  }));
}

}  // namespace
}  // namespace rebound
