// Data that once led a diagnosis to a name without evidence. Rates over seeds, not one seed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "comparisons/inference/calibration/autocorrelation.hpp"
#include "tests/support/gaussian_noise.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

using testing::believed_law;
using testing::diagnosis_of;
using testing::experiment_with;
using testing::measured_data;

/// Noise of the stated size whose neighbours are alike, and nothing else hidden.
Dataset null_with_correlated_noise(double coefficient, std::int64_t seed) {
  SynthesisFile file = experiment_with({}, seed);
  file.instrument.force_noise = 1e-9;
  file.sampling.before = 1e-3;
  Dataset dataset = measured_data(file);
  dataset.instrument.force_noise = 20.0;
  test::GaussianNoise normal(static_cast<std::uint64_t>(seed));
  for (MeasuredImpact& shot : dataset.shots) {
    double last = normal();
    for (double& force : shot.trace.force) {
      force += 20.0 * last;
      last = coefficient * last + std::sqrt(1.0 - coefficient * coefficient) * normal();
    }
  }
  return dataset;
}

int false_gaps(const std::function<Dataset(int)>& make, int count) {
  int gaps = 0;
  for (int seed = 0; seed < count; ++seed)
    if (diagnosis_of(make(seed)).verdict != DiagnosisVerdict::agrees) ++gaps;
  return gaps;
}

// Of 40 nulls at 5 %, six or more false gaps have a chance of 1.4 %.
TEST(NotFooledTest, CorrelatedNoiseIsNoGap) {
  for (const double coefficient : {0.5, 0.7})
    EXPECT_LE(
        false_gaps([&](int seed) { return null_with_correlated_noise(coefficient, seed); }, 20), 3)
        << coefficient;
}

// The colour is told by forty samples a shot: what they say of slow noise is worth thirteen that
// are independent.
TEST(NotFooledTest, CorrelatedNoiseIsNoGapWhereTheQuietIsShort) {
  const auto null = [](int seed) {
    SynthesisFile file = experiment_with({}, seed);
    file.sampling.rate = 200e3;
    file.sampling.before = 2e-4;
    file.instrument.noise_correlation_time = 1e-5;
    return measured_data(file);
  };
  EXPECT_LE(false_gaps(null, 20), 3);
}

TEST(NotFooledTest, NoiseStatedWrongByTwoIsSeenAndSaid) {
  int gaps = 0, said = 0;
  for (int seed = 0; seed < 20; ++seed) {
    SynthesisFile file = experiment_with({}, seed);
    file.sampling.before = 1e-3;
    Dataset dataset = measured_data(file);
    dataset.instrument.force_noise = seed % 2 == 0 ? 10.0 : 40.0;
    const Diagnosis d = diagnosis_of(dataset);
    gaps += d.verdict != DiagnosisVerdict::agrees;
    for (const auto& warning : d.warnings)
      said += warning.find("are stated; the scatter is taken") != std::string::npos;
  }
  EXPECT_LE(gaps, 3);
  EXPECT_EQ(said, 20);
}

/// Nothing hidden, but readings of the slowest shot that are too high while the ball is loaded [N].
Dataset lifted_while_loading(double lift, std::int64_t seed) {
  SynthesisFile file = experiment_with({}, seed);
  Dataset dataset = measured_data(file);
  file.instrument.force_noise = 0.0;
  const std::vector<double> force = measured_data(file).shots[0].trace.force;
  const auto top = std::max_element(force.begin(), force.end());
  for (auto f = force.begin(); f < top; ++f)
    if (*f > 0.25 * *top && *f < 0.85 * *top)
      dataset.shots[0].trace.force[static_cast<std::size_t>(f - force.begin())] += lift;
  return dataset;
}

// Of a thousand readings with 20 N of noise fifty are 8 N too high: χ² allows it, their mean is
// four standard deviations off.
TEST(NotFooledTest, AGapInOnePhaseOfOneShotIsNoAgreement) {
  const Diagnosis d = diagnosis_of(lifted_while_loading(8.0, 1));
  EXPECT_GT(d.believed.p_value, 0.1);
  EXPECT_GT(d.believed.map.largest, 1.2 * d.believed.map.threshold);
  EXPECT_NE(d.verdict, DiagnosisVerdict::agrees);
}

// A believed stiffness that is off by eight either way, and a damping by seventeen or six.
TEST(NotFooledTest, TheStartDoesNotDecide) {
  const Dataset dataset = measured_data(experiment_with({}, 21));
  const Diagnosis right = diagnosis_of(dataset);
  ASSERT_EQ(right.verdict, DiagnosisVerdict::agrees);
  for (const double stiffness : {0.125, 0.2, 8.0})
    for (const double damping : {1.0 / 17.0, 6.0}) {
      LumpedModel believed = believed_law();
      believed.parameters["stiffness"] *= stiffness;
      believed.parameters["damping"] *= damping;
      const Diagnosis d = diagnosis_of(dataset, believed);
      EXPECT_EQ(d.verdict, DiagnosisVerdict::agrees) << stiffness << " " << damping;
      EXPECT_NEAR(d.best().chi_square, right.best().chi_square, 0.5);
    }
}

TEST(NotFooledTest, AWrongGainOfOneShotIsNeverAPhysicalName) {
  int named = 0;
  for (int seed = 0; seed < 10; ++seed) {
    Dataset dataset = measured_data(experiment_with({}, 40 + seed));
    for (double& force : dataset.shots[static_cast<std::size_t>(seed) % 3].trace.force)
      force *= 1.03;
    const Diagnosis d = diagnosis_of(dataset);
    named += d.verdict == DiagnosisVerdict::missing;
  }
  EXPECT_EQ(named, 0);
}

// Relaxation in 30 ms is stiffness to an impact of 2 ms: nothing may be said against it.
TEST(NotFooledTest, ExcludedSizesCoverTheTruth) {
  const EffectChoice hidden{"relaxation", 0.3, {{"relaxation_time", 30e-3}}};
  for (int seed = 0; seed < 5; ++seed) {
    const Diagnosis d = diagnosis_of(measured_data(experiment_with({hidden}, 60 + seed)));
    for (const ExcludedSize& excluded : d.excluded) {
      if (excluded.name != "relaxation") continue;
      ASSERT_EQ(excluded.over.size(), 1u);
      EXPECT_TRUE(excluded.size > 0.3 || excluded.over[0].highest < 30e-3);
    }
  }
}

TEST(NotFooledTest, ThreeSpeedsMeasuredApartAreHeldOutTogether) {
  SynthesisFile file = experiment_with({}, 70);
  file.shots = {{.speed = 5.0, .speed_uncertainty = 0.02},
                {.speed = 14.89, .speed_uncertainty = 0.05},
                {.speed = 14.96, .speed_uncertainty = 0.05},
                {.speed = 14.97, .speed_uncertainty = 0.05},
                {.speed = 25.0, .speed_uncertainty = 0.1}};
  const Diagnosis d = diagnosis_of(measured_data(file));
  EXPECT_EQ(d.unseen->shots.size(), 3u);
  EXPECT_EQ(d.seen->shots.size(), 2u);
}

}  // namespace
}  // namespace rebound
