// The stable step of cells with a mean dilatation: eigenfrequencies of one cell, found
// from its forces by differences, against what the scheme takes for them.
#include <gtest/gtest.h>

#include "tests/support/cell_frequencies.hpp"

namespace rebound::fem {
namespace {

class NearlyIncompressibleStep : public ::testing::TestWithParam<ElasticModel> {};

TEST_P(NearlyIncompressibleStep, FrequencyOfCellAtRest) {
  test::Random random(21);
  for (int i = 0; i < 60; ++i) {
    const auto body = discretise(test::random_cell(random, i % 3 == 0), 1.0);
    Material material = test::unit_material(GetParam());
    material.poisson_ratio = 0.499;
    test::KernelCase cell(body, material, *find_cell_kernel("baseline"));
    const std::vector<double> rest(cell.size(), 0.0);
    cell.force(rest);
    const double bound = cell.summary().largest_frequency_squared;
    EXPECT_NEAR(test::largest_frequency_squared(body, cell, rest) / bound, 1.0,
                5e-6);  // of the difference quotients
  }
}

TEST_P(NearlyIncompressibleStep, FrequencyOfDeformedCell) {
  for (const double poisson_ratio : {0.46, 0.49, 0.499}) {
    test::Random random(22);
    double worst = 0.0;
    for (int i = 0; i < 300; ++i) {
      const auto body = discretise(test::random_cell(random, i % 3 == 0), 1.0);
      Material material = test::unit_material(GetParam());
      material.poisson_ratio = poisson_ratio;
      test::KernelCase cell(body, material, *find_cell_kernel("baseline"));
      const auto u = test::random_cell_motion(random, body, i % 2 == 0 ? 0.2 : 0.5);
      cell.force(u);
      const CellSummary summary = cell.summary();
      if (summary.smallest_jacobian < 0.15) continue;
      worst = std::max(worst, test::largest_frequency_squared(body, cell, u) /
                                  summary.largest_frequency_squared);
    }
    EXPECT_LT(worst, 1.03) << "Poisson ratio " << poisson_ratio;
    EXPECT_GT(worst, 0.5) << "the estimate wastes steps";
  }
}

INSTANTIATE_TEST_SUITE_P(Elastic, NearlyIncompressibleStep,
                         ::testing::ValuesIn(test::elastic_models));

}  // namespace
}  // namespace rebound::fem
