// What a joint model reports between the samples of its impacts.
#include "comparisons/discrepancy/diagnosis/fits/joint_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/diagnosis/observations/observe.hpp"
#include "comparisons/models/instrument/reported_force.hpp"
#include "lumped/integration/simulate.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

/// Largest distance of the reported force from that of the same impact with a hundred times as many
/// samples, over the peak.
double error_between_samples(std::vector<EffectChoice> effects) {
  const SynthesisFile file = testing::experiment_with({}, 1);
  const Observations seen = observe({synthesize(file, simulator_of(file, {})).dataset});
  const JointModel model(
      seen,
      {.believed = testing::believed_law(), .effects = effects, .model_discrepancy = nullptr});
  const std::vector<double> values = model.start();
  LumpedProblem problem = model.problem_at(values, 0);
  problem.controls.samples = 20001;
  const Trace fine = simulate_fast(problem).trace;
  const double touch = model.first_touch(values, 0), duration = fine.time.back();
  std::vector<double> time, since;
  for (int i = 0; i <= 4001; ++i) since.push_back(duration * i / 4001.0);
  for (const double t : since) time.push_back(touch + t);
  const std::vector<double> found = model.force_at(values, 0, time);
  const std::vector<double> expected = reported_force(fine, {}, since);
  double worst = 0.0;
  // The last instants are left out: a plate rings on there, and a force that jumps has two values.
  for (std::size_t i = 0; i + 10 < since.size(); ++i)
    worst = std::max(worst, std::abs(found[i] - expected[i]));
  return worst / *std::max_element(expected.begin(), expected.end());
}

// Noise of a quiet rig is a ten-thousandth of the peak: 1.4e-4 of it at the onset was a "plate".
TEST(JointModelTest, ForcesBetweenSamplesAreThoseOfTheImpact) {
  EXPECT_LT(error_between_samples({}), 5e-6);
}

// A plate of 3.5 kHz: cubic between samples; finer ends would make it 6e-5.
TEST(JointModelTest, SoAreThoseOnAPlateThatGivesWay) {
  EXPECT_LT(error_between_samples({{"plate-compliance", 1e-9, {}}}), 2e-5);
}

// A stated restitution is that of the body too: what its waves keep does not show in the force
// alone.
TEST(JointModelTest, WhatFemAddsActsOnScalarsToo) {
  const SynthesisFile file = testing::experiment_with({}, 1);
  Observations seen = observe({synthesize(file, simulator_of(file, {})).dataset});
  for (MeasuredImpact& shot : seen.shots)
    for (const ScalarQuantity& scalar : scalar_quantities) (shot.*scalar.measured).value = 1.0;
  auto gap = std::make_shared<ModelDiscrepancy>();
  for (const MeasuredImpact& shot : seen.shots) {
    DiscrepancyCurve curve{.speed = shot.impact.speed,
                           .first_phase = -0.1,
                           .phase_step = 0.1,
                           .force = std::vector<double>(15, 0.0)};
    curve.scalars[0] = -0.05;
    gap->curves.push_back(curve);
  }
  const Hypothesis alone{
      .believed = testing::believed_law(), .effects = {}, .model_discrepancy = nullptr};
  Hypothesis beside_fem = alone;
  beside_fem.model_discrepancy = gap;
  const JointModel without(seen, alone), with(seen, beside_fem);
  for (std::size_t i = 0; i < seen.shots.size(); ++i)
    for (const ScalarQuantity& scalar : scalar_quantities) {
      const double ratio = *(with.as_seen(with.start(), i).*scalar.measured).value /
                           *(without.as_seen(without.start(), i).*scalar.measured).value;
      EXPECT_NEAR(ratio, scalar.what == ObservedQuantity::restitution ? 0.95 : 1.0, 1e-12)
          << scalar.key;
    }
}

}  // namespace
}  // namespace rebound
