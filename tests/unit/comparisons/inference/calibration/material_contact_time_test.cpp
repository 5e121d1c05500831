// What a material is fitted to, seen with a body whose answer is a formula.
#include <gtest/gtest.h>

#include <cmath>

#include "comparisons/inference/calibration/material_calibration.hpp"

namespace rebound {
namespace {

/// Half-sine of force over T = 1 ms √(1 MPa/E); the record is a fifth longer than the contact.
FemResult half_sine(const FemProblem& problem) {
  FemResult result;
  const double duration = 1e-3 * std::sqrt(1e6 / problem.material.youngs_modulus);
  result.scalars.restitution = 0.5 + 0.01 * std::log(problem.material.youngs_modulus / 1e6);
  result.scalars.contact_time = duration;
  result.smallest_step = 1e-7;
  for (int i = 0; i <= 120; ++i) {
    const double t = 0.01 * i * duration;
    result.trace.time.push_back(t);
    result.trace.force.push_back(i < 100 ? 100.0 * std::sin(0.01 * M_PI * i) : 0.0);
  }
  return result;
}

double fitted_modulus(const MeasuredImpact& measured) {
  FemProblem problem;
  problem.material.youngs_modulus = 1.5e6;
  const auto numbers = material_numbers(problem.material, 30.0);
  return calibrate_material(problem, {measured}, {numbers.front()}, half_sine)
      .material.youngs_modulus;
}

TEST(MaterialContactTimeTest, EndsAtSeparationWithoutAThreshold) {
  const MeasuredImpact measured{
      .impact = {.speed = 5.0}, .restitution = {0.5, 0.01}, .contact_time = {1e-3, 1e-6}};
  EXPECT_NEAR(fitted_modulus(measured) / 1e6, 1.0, 1e-3);
}

TEST(MaterialContactTimeTest, IsTakenAboveTheThreshold) {
  // sin > ½ over two thirds of the contact.
  const MeasuredImpact measured{.impact = {.speed = 5.0},
                                .contact_threshold = 50.0,
                                .restitution = {0.5, 0.01},
                                .contact_time = {1e-3 * 2.0 / 3.0, 1e-6}};
  EXPECT_NEAR(fitted_modulus(measured) / 1e6, 1.0, 1e-3);
}

}  // namespace
}  // namespace rebound
