// A second ball that hits the first from behind: no force of the first one's deflection, rate or
// past, whatever curves are bent to it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

/// The ball of experiment_with(), and one of `share` times its mass that touches it from behind at
/// `delay` if the first one went on as it came.
struct TwoBalls {
  double mass, speed, share, delay;

  using State = std::array<double, 4>;  ///< deflection, its rate; the same of the second ball

  static double force(const State& y) {
    if (y[0] <= 0.0) return 0.0;
    return std::max(0.0, std::pow(y[0], 1.5) * (3.2e6 + 7e4 * y[1]));
  }
  State rate(const State& y) const {
    const double between = 3.2e6 * std::pow(std::max(0.0, y[2] - y[0]), 1.5);
    return {y[1], (between - force(y)) / mass, y[3], share > 0.0 ? -between / (share * mass) : 0.0};
  }
  State after(const State& y, double step) const {  // Runge and Kutta's
    const auto moved = [&](const State& slope, double by) {
      State at = y;
      for (std::size_t i = 0; i < at.size(); ++i) at[i] += by * slope[i];
      return at;
    };
    const State a = rate(y), b = rate(moved(a, step / 2)), c = rate(moved(b, step / 2)),
                d = rate(moved(c, step));
    State next = y;
    for (std::size_t i = 0; i < next.size(); ++i)
      next[i] += step / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
    return next;
  }
  /// Of the plate on the first ball, at multiples of `step`.
  std::vector<double> forces(double step, std::size_t count) const {
    constexpr int parts = 20;
    State y{0.0, speed, share > 0.0 ? -speed * delay : -1.0, share > 0.0 ? speed : 0.0};
    std::vector<double> all;
    for (std::size_t i = 0; i < count; ++i) {
      all.push_back(force(y));
      for (int part = 0; part < parts; ++part) y = after(y, step / parts);
    }
    return all;
  }
};

/// An honest experiment, and what the second ball changes in its records from the first touch on.
Dataset with_a_second_ball(double share, std::int64_t seed) {
  Dataset dataset = testing::measured_data(testing::three_times_each_speed({}, seed));
  for (MeasuredImpact& shot : dataset.shots) {
    const std::vector<double>& time = shot.trace.time;
    std::vector<double>& force = shot.trace.force;
    const auto touch =
        static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), 0.0) - time.begin());
    const double step = time[1] - time[0];
    TwoBalls balls{.mass = 89.6e-3, .speed = shot.impact.speed, .share = share, .delay = 0.4e-3};
    const auto with = balls.forces(step, time.size() - touch);
    balls.share = 0.0;
    const auto without = balls.forces(step, time.size() - touch);
    for (std::size_t i = touch; i < time.size(); ++i)
      force[i] += with[i - touch] - without[i - touch];
  }
  return dataset;
}

TEST(SecondBallTest, IsUnexplained) {
  for (const double share : {0.01, 0.03})
    for (int seed = 1; seed <= 2; ++seed) {
      const Diagnosis d = testing::diagnosis_of(with_a_second_ball(share, seed));
      EXPECT_EQ(d.verdict, DiagnosisVerdict::unexplained) << share << ", seed " << seed;
    }
}

}  // namespace
}  // namespace rebound
