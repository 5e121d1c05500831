// What experiments show of a hidden effect, against first order.
#include "comparisons/discrepancy/design/planned_pairs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "comparisons/discrepancy/design/hidden_sizes.hpp"
#include "comparisons/discrepancy/design/refitted_change.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

SynthesisFile plan_of(const std::vector<double>& speeds) {
  SynthesisFile plan = testing::coarse_experiment(5);
  plan.shots.clear();
  for (const double speed : speeds)
    plan.shots.push_back({.speed = speed, .speed_uncertainty = 0.02});
  return plan;
}

/// An effect of the size that raises χ² by 26, and the share of that which is seen.
struct Seen {
  Seen(const SynthesisFile& plan, const std::string& name)
      : data(planned_data(plan)), refitted(data) {
    const EffectCard& card = find_effect(name).card;
    hidden.name = name;
    const auto size = smallest_size(card, 1.0, [&](double one) {
      hidden.size = card.null + one;
      return refitted.rise(hidden).value_or(0.0) > 26.0;
    });
    hidden.size = card.null + size.value();
    length = std::sqrt(refitted.rise(hidden).value());
    share = PlannedPairs(plan, data).share_seen(hidden, refitted.by(hidden).value()).value();
  }
  PlannedData data;
  RefittedChange refitted;
  EffectChoice hidden{.name = {}, .size = 0.0, .parameters = {}};
  double length = 0.0, share = 0.0;
};

TEST(PlannedPairsTest, FirstOrderHoldsForWhatTheFitLeavesAlone) {
  const SynthesisFile plan = plan_of({5.0, 15.0, 25.0});
  EXPECT_NEAR(Seen(plan, "force-gain").share, 1.0, 0.02);
  EXPECT_NEAR(Seen(plan, "hysteresis").share, 1.0, 0.12);
}

/// Residuals along a dashpot around the fit to one experiment.
double along_dashpot(const SynthesisFile& experiment) {
  const PlannedData one = planned_data(experiment, {"linear-dashpot"});
  const auto& residuals = one.fit->residuals;
  const Eigen::Map<const Eigen::VectorXd> rows(residuals.data(), std::ssize(residuals));
  return one.around->all().at(0).sensitivity.normalized().dot(rows);
}

/// Other pairs, of other noise, show what these say, and not what first order says.
TEST(PlannedPairsTest, ADashpotAtTwoSpeedsIsSeenByLess) {
  const SynthesisFile plan = plan_of({6.0, 20.0});
  const Seen seen(plan, "linear-dashpot");
  constexpr int experiments = 80;
  double sum = 0.0;
  for (int k = 0; k < experiments; ++k) {
    SynthesisFile without = plan, with = plan;
    without.seed = with.seed = 100 + k;
    with.effects = {seen.hidden};
    sum += along_dashpot(without) - along_dashpot(with);
  }
  const double mean = sum / experiments;  // good to 0.1, as the other is to 0.15
  EXPECT_NEAR(mean, seen.share * seen.length, 0.45);
  EXPECT_LT(mean, seen.length - 0.45) << "first order";
}

}  // namespace
}  // namespace rebound
