// What a fitted model says of data that contradict themselves.
#include "comparisons/discrepancy/diagnosis/verdict/contradictions.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "comparisons/discrepancy/diagnosis/observations/observe.hpp"
#include "comparisons/discrepancy/diagnosis/output/diagnosis_json.hpp"
#include "comparisons/discrepancy/diagnosis/output/diagnosis_text.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

/// Restitutions of their own, and forces a fifth too large.
Dataset with_a_wrong_gain(std::int64_t seed) {
  SynthesisFile file = testing::experiment_with({}, seed);
  for (SynthesisShot& shot : file.shots) shot.restitution_uncertainty = 0.01;
  Dataset dataset = synthesize(file, simulator_of(file, {})).dataset;
  for (MeasuredImpact& shot : dataset.shots)
    for (double& force : shot.trace.force) force *= 1.2;
  return dataset;
}

/// A diagnosis whose verdict is one physical effect, beside others.
Diagnosis named_by(const Observations& all, const std::vector<EffectChoice>& effects) {
  Diagnosis d;
  d.checks = check_data(all);
  d.contradictions = contradictions_among(d.checks);
  d.selection.baseline.fit =
      fit_hypothesis(all, {.believed = testing::believed_law(), .effects = effects});
  d.verdict = DiagnosisVerdict::missing;
  d.family = EffectFamily::history;
  for (const EffectChoice& effect : effects) {
    NamedEffect named;
    named.effect = effect;
    d.effects.push_back(named);
  }
  d.believed_effects = effects.size();
  return d;
}

TEST(ContradictionsTest, AModelWithoutAFaultExplainsNone) {
  const Observations all = observe({with_a_wrong_gain(1)});
  Diagnosis d = named_by(all, {{"hysteresis", 0.05, {}}});
  ASSERT_FALSE(d.contradictions.empty());
  EXPECT_EQ(unexplained_contradictions(d, d.best(), all).size(), d.contradictions.size());
  withhold_names_from_contradictions(d, all);
  EXPECT_EQ(d.verdict, DiagnosisVerdict::family);
  EXPECT_NE(d.withheld.find("contradict"), std::string::npos);
}

TEST(ContradictionsTest, AFaultInTheModelExplainsThem) {
  const Observations all = observe({with_a_wrong_gain(2)});
  Diagnosis d = named_by(all, {{"hysteresis", 0.05, {}}, {"force-gain", 0.1, {}}});
  ASSERT_FALSE(d.contradictions.empty());
  EXPECT_TRUE(unexplained_contradictions(d, d.best(), all).empty());
  withhold_names_from_contradictions(d, all);
  EXPECT_EQ(d.verdict, DiagnosisVerdict::missing);
}

// The load cell reads less than the contact while the plate is set in motion.
TEST(ContradictionsTest, APlateThatMovesExplainsItsOwn) {
  const EffectCard& card = find_effect("plate-compliance").card;
  const EffectChoice plate{card.name, card.prior_scale, {}};
  int explained = 0;
  for (int seed = 4; seed <= 13; ++seed) {
    SynthesisFile file = testing::experiment_with({plate}, seed);
    file.instrument.deflection = DeflectionOrigin::independent;
    file.instrument.deflection_noise = 2e-5;
    for (SynthesisShot& shot : file.shots) shot.restitution_uncertainty = 0.01;
    const Observations all = observe({synthesize(file, simulator_of(file, {})).dataset});
    const Diagnosis d = named_by(all, {plate});
    EXPECT_FALSE(d.contradictions.empty());
    explained += unexplained_contradictions(d, d.best(), all).empty() ? 1 : 0;
  }
  EXPECT_GE(explained, 9);
}

TEST(ContradictionsTest, StandInResultAndText) {
  const Observations all = observe({with_a_wrong_gain(3)});
  const Diagnosis d = named_by(all, {});
  Diagnosis shown;
  shown.contradictions = d.contradictions;
  shown.checks = d.checks;
  EXPECT_EQ(to_json(shown).at("contradictions").size(), d.contradictions.size());
  const std::string text = to_text(shown);
  EXPECT_LT(text.find("impulse of"), text.find("VERDICT"));
}

}  // namespace
}  // namespace rebound
