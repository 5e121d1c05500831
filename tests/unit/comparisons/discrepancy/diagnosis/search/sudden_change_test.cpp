#include "comparisons/discrepancy/diagnosis/search/sudden_change.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/diagnosis/observations/observe.hpp"
#include "comparisons/discrepancy/diagnosis/search/assessed_fit.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

// Of a twentieth of sixty cases three are expected, at most: the chance is that of any of the
// points, as if they were independent.
TEST(SuddenChangeTest, OfNoiseItIsRare) {
  int below_twentieth = 0, below_all = 0;
  for (int seed = 500; seed < 560; ++seed) {
    const Observations seen = observe({testing::measured_data(testing::experiment_with({}, seed))});
    const HypothesisFit fit = fit_hypothesis(seen, {.believed = testing::believed_law()});
    const ScoreTest test =
        test_sudden_change(seen, fit, EffectSensitivities(seen, fit, {}), known_noise);
    ASSERT_EQ(test.freedom, 1);
    below_twentieth += test.p_value < 0.05 ? 1 : 0;
    below_all += test.p_value < 1.0 ? 1 : 0;
  }
  EXPECT_LE(below_twentieth, 8);  // three deviations beyond three
  EXPECT_GT(below_all, 6);        // and it is no test that never speaks
}

/// The ball of experiment_with(), whose stiffness is less by a share once it is six millimetres
/// deep: at five metres a second it never is.
struct BreakingBall {
  double speed, share;

  /// At multiples of `step`.
  std::vector<double> forces(double step, std::size_t count) const {
    constexpr int parts = 50;
    constexpr double mass = 89.6e-3, breaks_at = 6e-3;
    const double h = step / parts;
    double x = 0.0, v = speed, factor = 1.0;
    const auto force = [&](double at, double rate) {
      if (at <= 0.0) return 0.0;
      return factor * std::max(0.0, std::pow(at, 1.5) * (3.2e6 + 7e4 * rate));
    };
    std::vector<double> all;
    for (std::size_t i = 0; i < count; ++i) {
      all.push_back(force(x, v));
      for (int part = 0; part < parts; ++part) {  // the midpoint rule
        const double middle = v - 0.5 * h * force(x, v) / mass;
        v -= h * force(x + 0.5 * h * v, middle) / mass;
        x += h * middle;
        if (x > breaks_at) factor = 1.0 - share;
      }
    }
    return all;
  }
};

/// An honest experiment, and what breaking changes in its records from the first touch on.
Dataset of_breaking_balls(double share, std::int64_t seed) {
  Dataset dataset = testing::measured_data(testing::three_times_each_speed({}, seed));
  for (MeasuredImpact& shot : dataset.shots) {
    const std::vector<double>& time = shot.trace.time;
    const auto touch =
        static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), 0.0) - time.begin());
    const double step = time[1] - time[0];
    const auto with =
        BreakingBall{.speed = shot.impact.speed, .share = share}.forces(step, time.size() - touch);
    const auto without =
        BreakingBall{.speed = shot.impact.speed, .share = 0.0}.forces(step, time.size() - touch);
    for (std::size_t i = touch; i < time.size(); ++i)
      shot.trace.force[i] += with[i - touch] - without[i - touch];
  }
  return dataset;
}

TEST(SuddenChangeTest, SeesAStiffnessThatDrops) {
  const auto judged = [](double share) {
    const Observations seen = observe({of_breaking_balls(share, 11)});
    return judge_believed(seen, fit_hypothesis(seen, {.believed = testing::believed_law()}),
                          absent_effects({}), {}, 1);
  };
  const AssessedFit broken = judged(0.015), sound = judged(0.0);
  EXPECT_GT(broken.p_value, 0.001);
  EXPECT_LT(broken.sudden.p_value, 1e-3);
  EXPECT_FALSE(broken.adequate);
  EXPECT_GT(sound.sudden.p_value, 1e-2);
  EXPECT_TRUE(sound.adequate);
}

TEST(SuddenChangeTest, ABallThatBreaksIsUnexplained) {
  for (const double share : {0.03, 0.06})
    for (int seed = 1; seed <= 2; ++seed) {
      const Diagnosis d = testing::diagnosis_of(of_breaking_balls(share, seed));
      EXPECT_EQ(d.verdict, DiagnosisVerdict::unexplained) << share << ", seed " << seed;
    }
}

}  // namespace
}  // namespace rebound
