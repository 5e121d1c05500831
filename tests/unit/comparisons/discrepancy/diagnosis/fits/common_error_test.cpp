#include "comparisons/discrepancy/diagnosis/fits/common_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rebound {
namespace {

constexpr std::size_t samples = 240;
constexpr double peak = 1000.0, white_noise = 10.0;

/// So many records of one half-sine, whose numerical error is `error` [N].
Observations half_sines(std::size_t shots, double error) {
  Observations seen;
  seen.balls.resize(1);
  for (std::size_t k = 0; k < shots; ++k) {
    MeasuredImpact shot;
    for (std::size_t i = 0; i < samples; ++i) {
      shot.trace.time.push_back(1e-5 * static_cast<double>(i));
      shot.trace.force.push_back(peak *
                                 std::sin(std::numbers::pi * static_cast<double>(i) / samples));
    }
    shot.noise.deviation = white_noise;
    shot.noise.shared = error;
    seen.shots.push_back(std::move(shot));
  }
  return seen;
}

CommonError error_of(const Observations& seen) {
  std::vector<std::size_t> begins;
  for (std::size_t k = 0; k < seen.shots.size(); ++k) begins.push_back(k * samples);
  return {seen, begins, seen.shots.size() * samples};
}

/// χ² of all shots where each reads too much by `force` newtons, at any instant of the contact.
double left_of(std::size_t shots, double error, double force) {
  const Observations seen = half_sines(shots, error);
  std::vector<double> residuals(shots * samples, force / white_noise);
  error_of(seen).take_out(residuals);
  double sum = 0.0;
  for (const double r : residuals) sum += r * r;
  return sum;
}

/// Eight errors of one standard deviation each count eight, whether they are seen once or thirty
/// times; the ends of a contact, where no force shows, are left.
TEST(CommonErrorTest, ManyShotsKnowNoMoreThanOne) {
  const double once = left_of(1, white_noise, white_noise),
               often = left_of(30, white_noise, white_noise);
  EXPECT_GT(left_of(30, 0.0, white_noise), 7000.0);
  EXPECT_LT(once, 8.0 + 0.1 * samples);
  EXPECT_LT(often - 30.0 * (once - 8.0), 9.0);
}

TEST(CommonErrorTest, WithoutAnErrorNoBitChanges) {
  const Observations seen = half_sines(2, 0.0);
  std::vector<double> residuals(2 * samples);
  for (std::size_t i = 0; i < residuals.size(); ++i)
    residuals[i] = std::sin(static_cast<double>(i));
  const std::vector<double> before = residuals;
  error_of(seen).take_out(residuals);
  EXPECT_EQ(residuals, before);
}

/// What changes from sample to sample is no error of a phase.
TEST(CommonErrorTest, NoiseStays) {
  const Observations seen = half_sines(3, white_noise);
  std::vector<double> residuals;
  for (std::size_t i = 0; i < 3 * samples; ++i) residuals.push_back(i % 2 == 0 ? 1.0 : -1.0);
  error_of(seen).take_out(residuals);
  for (std::size_t i = 0; i < residuals.size(); ++i)
    EXPECT_NEAR(residuals[i], i % 2 == 0 ? 1.0 : -1.0, 0.02) << i;
}

/// Errors of two balls are two errors.
TEST(CommonErrorTest, EachBallHasItsOwn) {
  Observations seen = half_sines(2, white_noise);
  seen.balls.resize(2);
  seen.shots[1].ball = 1;
  std::vector<double> opposite(2 * samples, 1.0);
  std::fill(opposite.begin() + samples, opposite.end(), -1.0);
  std::vector<double> of_one = opposite;
  error_of(seen).take_out(opposite);
  error_of(half_sines(2, white_noise)).take_out(of_one);
  const std::size_t middle = samples / 2;
  EXPECT_LT(std::abs(opposite[middle]), 0.3) << "thirty samples know an eighth to 1/5 of it";
  EXPECT_NEAR(of_one[middle], 1.0, 1e-9) << "one ball errs alike in both";
}

}  // namespace
}  // namespace rebound
