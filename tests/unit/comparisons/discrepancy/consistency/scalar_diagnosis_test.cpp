#include "comparisons/discrepancy/consistency/scalar_diagnosis.hpp"

#include <gtest/gtest.h>

#include "comparisons/io/dataset/read_dataset.hpp"
#include "tests/support/refusals.hpp"

namespace rebound {
namespace {

Material two_numbers_a_branch(int branches) {
  Material material;
  material.youngs_modulus = 5e6;
  material.poisson_ratio = 0.4;
  material.modulus = ModulusBasis::long_term;
  for (int i = 0; i < branches; ++i)
    material.branches.push_back({.ratio = 1.0, .relaxation_time = 1e-4});
  return material;
}

TEST(ScalarDiagnosisTest, MoreNumbersThanScalarsAreRefused) {
  const Dataset data = read_dataset(REBOUND_DATA_FOLDER "/sliotar-core-a");
  const Observations all = all_scalars(data, {});
  EXPECT_TRUE(enough_scalars(all, two_numbers_a_branch(6)));  // 15 scalars for 13 numbers
  EXPECT_FALSE(enough_scalars(all, two_numbers_a_branch(7)));
  FemProblem believed{.sphere = data.sphere};
  believed.material = two_numbers_a_branch(7);
  const Error refused = testing::refusal_of([&] { diagnose_scalars(data, believed, {}); });
  EXPECT_EQ(refused.code(), ExitCode::bad_input);
}

}  // namespace
}  // namespace rebound
