// What is read where nothing touches is the measurement alone.
#include "comparisons/discrepancy/diagnosis/search/record_after_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "comparisons/discrepancy/diagnosis/observations/observe.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

constexpr double drift = 1e4;  // 10 N a millisecond after first touch; the noise is 20 N

Observations seen_with(std::vector<EffectChoice> hidden, double after = 2.5e-3) {
  SynthesisFile file = testing::experiment_with(std::move(hidden), 3);
  file.sampling.after = after;
  return observe({synthesize(file, simulator_of(file, {})).dataset});
}

/// A hypothesis with the numbers that it states.
HypothesisFit stated(const Observations& seen, std::vector<EffectChoice> effects) {
  HypothesisFit fit;
  fit.effects = effects;
  fit.model =
      std::make_shared<const JointModel>(seen, Hypothesis{.believed = testing::believed_law(),
                                                          .effects = std::move(effects),
                                                          .model_discrepancy = nullptr});
  fit.values = fit.model->start();
  return fit;
}

double against(const Observations& seen, const EffectChoice& fault) {
  return chi_square_against_faults(seen, stated(seen, {fault}));
}

bool denies(const Observations& seen, const EffectChoice& fault) {
  return std::isinf(against(seen, fault));
}

TEST(RecordAfterContactTest, ADriftThatIsNotThereIsDenied) {
  const Observations seen = seen_with({});
  EXPECT_TRUE(denies(seen, {"force-drift", drift, {}}));
  EXPECT_TRUE(denies(seen, {"force-drift", -drift, {}}));
  EXPECT_TRUE(denies(seen, {"droop", 2e3, {}})) << "an undershoot in proportion to the impulse";
}

TEST(RecordAfterContactTest, ADriftThatIsThereIsNotDenied) {
  const Observations drifting = seen_with({{"force-drift", drift, {}}});
  EXPECT_FALSE(denies(drifting, {"force-drift", drift, {}}));
  EXPECT_TRUE(denies(drifting, {"force-drift", -drift, {}}));
  EXPECT_FALSE(denies(drifting, {"force-drift", 1.0, {}})) << "as good as none";
}

/// A drift too small to be denied is less likely where it is not; where it is, none is preferred.
TEST(RecordAfterContactTest, ASmallDriftCountsInTheComparison) {
  const EffectChoice small{"force-drift", 0.1 * drift, {}};
  const double not_there = against(seen_with({}), small);
  EXPECT_GT(not_there, 3.0);
  EXPECT_LT(not_there, 75.0);
  EXPECT_EQ(against(seen_with({small}), small), 0.0);
}

/// Slow noise that lies like a drift in one record is no drift of the others.
TEST(RecordAfterContactTest, OneRecordIsEnough) {
  Observations seen = seen_with({{"force-drift", drift, {}}});
  ASSERT_EQ(seen.shots.size(), 3u) << seen.warnings.back();
  const Observations quiet = seen_with({});
  seen.shots[2].after_contact = quiet.shots[2].after_contact;
  EXPECT_TRUE(denies(seen, {"force-drift", drift, {}}));
}

TEST(RecordAfterContactTest, NothingIsSaidOfPhysicsNorWithoutARecord) {
  EXPECT_FALSE(denies(seen_with({}), {"adhesion", 500.0, {}}));
  EXPECT_FALSE(denies(seen_with({}, 0.0), {"force-drift", drift, {}}));
}

/// An effect may be fitted beside a fault without which nothing rebounds.
TEST(RecordAfterContactTest, AnImpactWithoutAnEndSaysNothing) {
  const Observations seen = seen_with({});
  HypothesisFit fit = stated(seen, {{"force-drift", drift, {}}});
  const auto& unknowns = fit.model->unknowns();
  for (std::size_t i = 0; i < unknowns.size(); ++i)
    if (unknowns[i].name.find("damping") != std::string::npos) fit.values[i] = 1e12;
  EXPECT_EQ(chi_square_against_faults(seen, fit), 0.0);
}

TEST(RecordAfterContactTest, ItIsTheQuietAndNotTheContact) {
  const Observations seen = seen_with({});
  for (const MeasuredImpact& shot : seen.shots) {
    ASSERT_FALSE(shot.after_contact.time.empty());
    EXPECT_GT(shot.after_contact.time.front(), shot.trace.time.back());
    EXPECT_EQ(shot.after_contact.time.size(), shot.after_contact.force.size());
    for (const double force : shot.after_contact.force) EXPECT_LT(std::abs(force), 100.0);
  }
}

}  // namespace
}  // namespace rebound
