#include "comparisons/discrepancy/diagnosis/output/residual_pictures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "tests/support/gaussian_noise.hpp"

namespace rebound {
namespace {

MeasuredImpact history_of(std::size_t samples, double deviation) {
  MeasuredImpact history{.noise = {.deviation = deviation}};
  for (std::size_t i = 0; i < samples; ++i) history.trace.time.push_back(1e-5 * i);
  history.trace.force.assign(samples, 0.0);
  return history;
}

TEST(ResidualPicturesTest, AConstantOffsetGrowsAsTheRootOfWhatIsTakenTogether) {
  const MeasuredImpact history = history_of(208, 2.0);
  const auto gathered = gathered_residuals(history, std::vector<double>(208, 3.0), 50);
  ASSERT_EQ(gathered.z.size(), 52u);
  for (const double z : gathered.z) EXPECT_NEAR(z, 1.5 * std::sqrt(4.0), 1e-12);
  EXPECT_NEAR(gathered.time.front(), 1.5e-5, 1e-18);
  EXPECT_NEAR(gathered.time.back(), 205.5e-5, 1e-15);
}

TEST(ResidualPicturesTest, NoiseAloneHasUnitVariance) {
  MeasuredImpact history = history_of(20000, 7.0);
  test::GaussianNoise noise(3);
  for (double& force : history.trace.force) force = 7.0 * noise();
  const auto z = gathered_residuals(history, std::vector<double>(20000, 0.0), 2000).z;
  const double square = std::inner_product(z.begin(), z.end(), z.begin(), 0.0);
  EXPECT_NEAR(square / static_cast<double>(z.size()), 1.0, 3.0 * std::sqrt(2.0 / 2000.0));
}

TEST(ResidualPicturesTest, TheFigureHoldsTheNoiseBeforeAndAfter) {
  const MeasuredImpact history = history_of(100, 1.0);
  const std::vector<double> before(100, 2.0), after(100, 0.0);
  const auto both = residual_figure(history, before, &after, report::Origin::predicted);
  ASSERT_EQ(both.series.size(), 3u);
  EXPECT_NEAR(both.series[0].y_high.front(), 1.96, 1e-12);
  EXPECT_GT(both.series[1].y.front(), both.series[0].y_high.front());
  EXPECT_EQ(both.series[2].y.front(), 0.0);
  EXPECT_EQ(residual_figure(history, before, nullptr, report::Origin::fitted).series.size(), 2u);
}

}  // namespace
}  // namespace rebound
