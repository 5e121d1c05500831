// The stable step: eigenfrequencies of one cell, found from its forces by
// differences, against what the scheme takes for them.
#include <gtest/gtest.h>

#include "tests/support/cell_frequencies.hpp"

namespace rebound::fem {
namespace {

using test::largest_frequency_squared;
using test::random_cell;

class StableStep : public ::testing::TestWithParam<ElasticModel> {};

TEST_P(StableStep, FrequencyOfCellAtRest) {
  test::Random random(21);
  for (int i = 0; i < 60; ++i) {
    const auto body = discretise(random_cell(random, i % 3 == 0), 1.0);
    test::KernelCase cell(body, test::unit_material(GetParam()), *find_cell_kernel("baseline"));
    const std::vector<double> rest(cell.size(), 0.0);
    cell.force(rest);
    const double at_rest = cell.summary().largest_frequency_squared;
    EXPECT_NEAR(largest_frequency_squared(body, cell, rest) / at_rest, 1.0, 1e-8);
  }
}

TEST_P(StableStep, FrequencyOfDeformedCell) {
  // Strains up to 0.65: what a step safety of 1 would let pass is 1.
  for (const double poisson_ratio : {0.0, 0.3, 0.4, 0.45}) {
    test::Random random(22);
    double worst = 0.0;
    for (int i = 0; i < 300; ++i) {
      const auto body = discretise(random_cell(random, i % 3 == 0), 1.0);
      Material material = test::unit_material(GetParam());
      material.poisson_ratio = poisson_ratio;
      test::KernelCase cell(body, material, *find_cell_kernel("baseline"));
      const auto u = test::random_cell_motion(random, body, i % 2 == 0 ? 0.2 : 0.5);
      cell.force(u);
      const CellSummary summary = cell.summary();
      if (summary.smallest_jacobian < 0.15) continue;
      worst = std::max(
          worst, largest_frequency_squared(body, cell, u) / summary.largest_frequency_squared);
    }
    EXPECT_LT(worst, 1.03) << "Poisson ratio " << poisson_ratio;
    EXPECT_GT(worst, 0.5) << "the estimate wastes steps";
  }
}

INSTANTIATE_TEST_SUITE_P(Elastic, StableStep, ::testing::ValuesIn(test::elastic_models));

}  // namespace
}  // namespace rebound::fem
