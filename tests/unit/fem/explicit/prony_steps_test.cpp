#include "fem/explicit/prony_steps.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/refusals.hpp"

namespace rebound::fem {
namespace {

constexpr double relaxation_time = 0.7;

ViscoelasticConstants one_branch() {
  ViscoelasticConstants constants;
  constants.branches = {{0.4, 0.3, relaxation_time}};
  return constants;
}

/// The branch stress as the kernels carry it, driven by a scalar stress D.
class Branch {
 public:
  double stress(const BranchStep& step, double drive) {
    const double q = carried_ + step.gain * drive;
    carried_ = step.decay_next * q - step.gain_next * drive;
    return q;
  }

 private:
  double carried_ = 0.0;
};

TEST(PronyStepsTest, ExactForLinearStressWithChangingSteps) {
  PronySteps steps(one_branch(), 0.05);
  Branch branch;
  double time = 0.0;
  double step = 0.05;
  for (int i = 0; i < 200; ++i) {
    const double exact = 3.0 * relaxation_time * -std::expm1(-time / relaxation_time);
    // Rounding alone: the carried tensor is a small difference of Q and D.
    ASSERT_NEAR(branch.stress(*steps.data(), 3.0 * time), exact, 1e-15 * (1.0 + 3.0 * time)) << i;
    time += step;
    // Equal, shorter, longer, from a thousandth of τ to thrice τ.
    step = i % 4 < 2 ? step : relaxation_time * std::pow(10.0, -3.0 + 3.5 * (i % 7) / 6.0);
    steps.advance(step);
  }
}

TEST(PronyStepsTest, ExactWhenTheStressIsHeldAfterARamp) {
  // Up with slope 1 to t = 1 in four steps, then held: Q decays from there.
  PronySteps steps(one_branch(), 0.25);
  Branch branch;
  double time = 0.0;
  const double at_corner = relaxation_time * -std::expm1(-1.0 / relaxation_time);
  for (int i = 0; i < 40; ++i) {
    const double exact = i <= 4 ? relaxation_time * -std::expm1(-time / relaxation_time)
                                : at_corner * std::exp(-(time - 1.0) / relaxation_time);
    ASSERT_NEAR(branch.stress(*steps.data(), std::min(time, 1.0)), exact, 1e-15) << i;
    time += i < 4 ? 0.25 : 0.1;
    steps.advance(i + 1 < 4 ? 0.25 : 0.1);
  }
}

TEST(PronyStepsTest, SharesArePassedOn) {
  const PronySteps steps(one_branch(), 0.1);
  EXPECT_EQ(steps.data()->deviatoric_share, 0.4);
  EXPECT_EQ(steps.data()->volumetric_share, 0.3);
}

TEST(PronyStepsTest, RefusesTooManyBranches) {
  ViscoelasticConstants constants;
  constants.branches.assign(largest_branch_count, {0.01, 0.01, 1.0});
  EXPECT_NO_THROW(PronySteps(constants, 0.1));
  constants.branches.push_back({0.01, 0.01, 1.0});
  EXPECT_EQ(testing::refusal_of([&] { PronySteps(constants, 0.1); }).code(), ExitCode::bad_input);
}

}  // namespace
}  // namespace rebound::fem
