#include "comparisons/models/instrument/channel_filter.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/refusals.hpp"

namespace rebound {
namespace {

constexpr double interval = 1e-5;

std::vector<double> sine(double frequency, int samples) {
  std::vector<double> signal;
  for (int i = 0; i < samples; ++i)
    signal.push_back(std::sin(2.0 * std::numbers::pi * frequency * i * interval));
  return signal;
}

/// Amplitude at a frequency, by projection, in the middle half.
double gain(double frequency, double channel_class) {
  const int samples = static_cast<int>(40.0 / frequency / interval);
  const auto filtered = channel_filtered(sine(frequency, samples), interval, channel_class);
  const auto in = sine(frequency, samples);
  double product = 0.0, square = 0.0;
  for (int i = samples / 4; i < 3 * samples / 4; ++i) {
    product += filtered[static_cast<std::size_t>(i)] * in[static_cast<std::size_t>(i)];
    square += in[static_cast<std::size_t>(i)] * in[static_cast<std::size_t>(i)];
  }
  return product / square;
}

class ChannelFilterTest : public ::testing::TestWithParam<double> {};

TEST_P(ChannelFilterTest, HalfPowerAtTheCornerWithoutDelay) {
  const double corner = class_corner(GetParam());
  EXPECT_NEAR(gain(corner, GetParam()), std::numbers::sqrt2 / 2.0, 2e-3);
  EXPECT_NEAR(gain(corner / 8.0, GetParam()), 1.0, 1e-3);
  EXPECT_LT(gain(4.0 * corner, GetParam()), 0.01);
  EXPECT_NEAR(corner / GetParam(), 1.6667, 1e-3);
}
INSTANTIATE_TEST_SUITE_P(Classes, ChannelFilterTest, ::testing::ValuesIn(channel_classes));

TEST(ChannelFilterEnds, AnOffsetStaysWhatItIs) {
  for (const double value : channel_filtered(std::vector<double>(500, 7.0), interval, 600.0))
    EXPECT_NEAR(value, 7.0, 1e-9);
}

TEST(ChannelFilterEnds, ASymmetricPulseStaysSymmetric) {
  std::vector<double> pulse(801, 0.0);
  for (int i = -100; i <= 100; ++i)
    pulse[static_cast<std::size_t>(400 + i)] = std::cos(std::numbers::pi * i / 200.0);
  const auto filtered = channel_filtered(pulse, interval, 1000.0);
  for (std::size_t i = 0; i < filtered.size(); ++i)
    EXPECT_NEAR(filtered[i], filtered[filtered.size() - 1 - i], 1e-6);
}

TEST(ChannelFilterEnds, TooFewSamplesASecondAreRefused) {
  EXPECT_EQ(testing::refusal_of([] {
              channel_filtered({0, 1, 0}, 1e-3, 180.0);
            }).code(),
            ExitCode::bad_input);
}

}  // namespace
}  // namespace rebound
