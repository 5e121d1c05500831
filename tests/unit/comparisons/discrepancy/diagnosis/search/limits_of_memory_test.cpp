// A branch that fades at once is a damper; one that does not fade leaves a lower way back.
#include "comparisons/discrepancy/diagnosis/search/limits_of_memory.hpp"

#include <gtest/gtest.h>

#include "comparisons/discrepancy/diagnosis/observations/observe.hpp"
#include "lumped/integration/simulate.hpp"
#include "tests/support/lumped_cases.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

// q = s τ Ḟ_e = s τ (3/2) k √x ẋ, the damper of Kuwabara and Kono with A = s τ.
TEST(LimitsOfMemoryTest, AFastBranchIsADamper) {
  LumpedProblem damper = test::typical_problem("kuwabara-kono");
  const double k = damper.model.parameters.at("stiffness"), a = 1e-5;
  damper.model.parameters["dissipation_time"] = a;
  LumpedProblem branch = test::typical_problem("hunt-crossley");
  branch.model.parameters = {{"stiffness", k}, {"damping", 0.0}};
  const LumpedResult expected = simulate(damper);
  const double time = 0.01 * expected.scalars.contact_time;
  branch.model.mechanisms.relaxation = {.ratio = a / time, .relaxation_time = time};
  const LumpedResult found = simulate(branch);
  EXPECT_NEAR(found.scalars.peak_force / expected.scalars.peak_force, 1.0, 2e-3);
  EXPECT_NEAR(found.scalars.restitution, expected.scalars.restitution, 2e-3);
}

/// The hypothesis that a branch of this time is there, as a fit of data in which nothing is hidden.
HypothesisFit fit_with_branch(const Observations& seen, double time) {
  Hypothesis hypothesis{.believed = testing::believed_law(),
                        .effects = {{"relaxation", 0.1, {{"relaxation_time", time}}}},
                        .model_discrepancy = nullptr};
  HypothesisFit fit;
  fit.effects = hypothesis.effects;
  fit.model = std::make_shared<const JointModel>(seen, hypothesis);
  fit.values = fit.model->start();
  return fit;
}

TEST(LimitsOfMemoryTest, TheTimeSaysWhatAMemoryIs) {
  const SynthesisFile file = testing::experiment_with({}, 1);
  const Observations seen = observe({synthesize(file, simulator_of(file, {})).dataset});
  const double contact = 1e-3;  // about
  const HypothesisFit fast = fit_with_branch(seen, 1e-3 * contact),
                      within = fit_with_branch(seen, contact),
                      slow = fit_with_branch(seen, 30.0 * contact);
  EXPECT_EQ(acting_family(seen, fast, 0), EffectFamily::rate);
  EXPECT_EQ(acting_family(seen, within, 0), EffectFamily::memory);
  EXPECT_EQ(acting_family(seen, slow, 0), EffectFamily::memory);
  EXPECT_FALSE(is_slow_memory_alone(seen, within, 0));
  EXPECT_TRUE(is_slow_memory_alone(seen, slow, 0));
  EXPECT_FALSE(is_slow_memory_alone(seen, slow, 1));
}

}  // namespace
}  // namespace rebound
