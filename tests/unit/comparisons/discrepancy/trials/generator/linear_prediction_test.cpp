#include "comparisons/discrepancy/trials/generator/linear_prediction.hpp"

#include <gtest/gtest.h>

namespace trials::testing {
namespace {

struct Colour {
  NoiseColour colour;
  double parameter;
  double white_beside = 0.0;
};

class EveryColour : public ::testing::TestWithParam<Colour> {};

// What is left of drawn noise has unit variance, and neighbours tell nothing of each other.
TEST_P(EveryColour, IsWhiteOncePredicted) {
  const Noise noise{
      .colour = GetParam().colour, .parameter = GetParam().parameter, .deviation = 3.0};
  Random random({1, "prediction", 1, 1});
  std::vector<std::array<double, 1>> rows;
  for (const double value : draw_noise(noise, 40000, random))
    rows.push_back({value + GetParam().white_beside * random.normal()});
  LinearPrediction(noise, GetParam().white_beside).whiten(rows);
  double square = 0.0, next = 0.0, fifth = 0.0;
  for (std::size_t i = 5; i < rows.size(); ++i) {
    square += rows[i][0] * rows[i][0];
    next += rows[i][0] * rows[i - 1][0];
    fifth += rows[i][0] * rows[i - 5][0];
  }
  const auto count = static_cast<double>(rows.size());
  EXPECT_NEAR(square / count, 1.0, 0.03);  // four standard errors
  EXPECT_NEAR(next / count, 0.0, 0.02);
  EXPECT_NEAR(fifth / count, 0.0, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Noise, EveryColour,
                         ::testing::Values(Colour{NoiseColour::white, 0.0},
                                           Colour{NoiseColour::autoregressive, 0.7},
                                           Colour{NoiseColour::band_limited, 0.1},
                                           Colour{NoiseColour::one_over_f, 0.0},
                                           Colour{NoiseColour::white, 0.0, 2.0},
                                           Colour{NoiseColour::autoregressive, 0.95, 1.0},
                                           Colour{NoiseColour::band_limited, 0.1, 0.5}));

}  // namespace
}  // namespace trials::testing
