#include "comparisons/inference/calibration/law_factors.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rebound {
namespace {

LumpedModel believed() {
  LumpedModel model;
  model.parameters = {{"exponent", 1.5}, {"stiffness", 3e6}, {"damping", 8e4}};
  model.at_speed = {{.speed = 5.0, .parameters = {{"damping", 4e4}}}};
  return model;
}

// The unknown of a number is the logarithm of what it is multiplied with.
TEST(LawFactorsTest, MultiplyTheNumbersOfTheirOwnBall) {
  std::vector<CalibrationParameter> unknowns;
  const LawFactors factors(believed(), {{.name = "one"}, {.name = "two"}}, unknowns);
  ASSERT_EQ(unknowns.size(), 4u);
  std::vector<double> values(4, 0.0);
  EXPECT_EQ(factors.at(values, 0), believed());
  for (std::size_t i = 0; i < values.size(); ++i)
    if (unknowns[i].name == "damping of two") values[i] = std::log(2.5);
  EXPECT_EQ(factors.at(values, 0), believed());
  const LumpedModel two = factors.at(values, 1);
  EXPECT_NEAR(two.parameters.at("damping") / 8e4, 2.5, 1e-14);
  EXPECT_NEAR(two.at_speed[0].parameters.at("damping") / 4e4, 2.5, 1e-14);
  EXPECT_EQ(two.parameters.at("stiffness"), 3e6);
}

}  // namespace
}  // namespace rebound
