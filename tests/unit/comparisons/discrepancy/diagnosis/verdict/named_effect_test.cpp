#include "comparisons/discrepancy/diagnosis/verdict/named_effect.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "comparisons/discrepancy/diagnosis/observations/observe.hpp"
#include "comparisons/inference/calibration/effective_residuals.hpp"
#include "comparisons/inference/calibration/held_parameter.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

/// 2 ΔC of a fit when an unknown is held at a value and all others are searched again.
double rise_at(const HypothesisFit& fit, std::size_t unknown, double value) {
  const CalibrationProblem problem = with_priors(fit.model->problem());
  HeldParameter held(problem, unknown, fit.search.values());
  const auto best = held.start(fit.search.estimates[unknown].value, fit.search.cost_after);
  return 2.0 * (held.point_at(value, best, best, {}).cost - fit.search.cost_after);
}

// A plate whose mass and compliance the data tell only by their product, its frequency: the size is
// known to a factor, and where the cost has risen by 3.84 (χ², 95 % of one number) is not where a
// straight line through the estimate says.
TEST(NamedEffectTest, SizeHasItsLikelihoodRatioInterval) {
  const EffectChoice plate{.name = "plate-compliance", .size = 5e-9, .parameters = {{"mass", 1.0}}};
  const Observations data = observe({testing::measured_data(testing::experiment_with({plate}, 3))});
  const HypothesisFit fit =
      fit_hypothesis(data, {.believed = testing::believed_law(), .effects = {plate}});
  const NumberWithInterval size = named_effect(fit, 0).size;
  ASSERT_LT(size.low, size.value);
  ASSERT_GT(size.high, size.value);

  const std::size_t unknown = fit.model->unknowns_of_effect(0).front();
  EXPECT_NEAR(rise_at(fit, unknown, std::log(size.low)), 3.84, 0.2);
  EXPECT_NEAR(rise_at(fit, unknown, std::log(size.high)), 3.84, 0.2);
  const Estimate& linearised = fit.search.estimates[unknown];
  const double half = 0.5 * (linearised.high - linearised.low);
  EXPECT_GT(std::abs(std::log(size.low) - linearised.low) +
                std::abs(std::log(size.high) - linearised.high),
            0.1 * half);
}

}  // namespace
}  // namespace rebound
