#include "comparisons/accuracy/numerical_error/coverage.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "comparisons/accuracy/numerical_error/coverage_store.hpp"
#include "lumped/problem/error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace rebound {
namespace {

CoverageRow row(FamilyUse use, int cells, const FamilyValues& values) {
  return {.number = 3,
          .point = {.speed = 0.1, .poisson_ratio = 0.4, .branch_share = 0.2, .branch_time = 0.5},
          .use = use,
          .cells = cells,
          .quantity = "restitution",
          .values = values};
}

TEST(CoverageTest, LinesComeBack) {
  const testing::TemporaryFolder folder;
  const CoverageRow written = row(FamilyUse::bars, 250, {0.9, 0.91, 0.912, 0.9101, 1e-4, 2e-4});
  std::ofstream(folder.path() / "t.csv") << coverage_heading() << "\n" << to_csv(written);
  const auto rows = read_coverage(folder.path() / "t.csv");
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].point, written.point);
  EXPECT_EQ(rows[0].cells, 250);
  EXPECT_EQ(rows[0].quantity, "restitution");
  EXPECT_DOUBLE_EQ(rows[0].values.fine, 0.912);
  EXPECT_DOUBLE_EQ(rows[0].values.ripple, 2e-4);
  std::ofstream(folder.path() / "t.csv", std::ios::app) << "3,0.1,broken\n";
  EXPECT_THROW(read_coverage(folder.path() / "t.csv"), Error);
}

TEST(CoverageStoreTest, AFamilyComesBackWithEveryBit) {
  CoverageRow one = row(FamilyUse::bars, 250, {1.0 / 3.0, 0.91, 0.912, 0.9101, 1e-4, 0.0});
  CoverageRow other = one;
  other.quantity = "peak_force_N";
  other.values.ripple = 5e-324;
  const auto rows = rows_of(member_of({one, other}), row(FamilyUse::bars, 250, {}));
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[1].quantity, "peak_force_N");
  EXPECT_EQ(rows[0].values.coarse, 1.0 / 3.0);
  EXPECT_EQ(rows[1].values.ripple, 5e-324);
  EXPECT_EQ(rows[1].point, one.point);
  MemberResult cut = member_of({one});
  cut.values.pop_back();
  EXPECT_THROW(rows_of(cut, one), Error);
}

TEST(CoverageStoreTest, AnotherImpactUseProgramOrMeshIsAnotherFamily) {
  FemProblem problem;
  problem.impact.speed = 3.0;
  const std::string key = key_of_family("p", problem, FamilyUse::bars, 250);
  EXPECT_EQ(key, key_of_family("p", problem, FamilyUse::bars, 250));
  EXPECT_NE(key, key_of_family("q", problem, FamilyUse::bars, 250));
  EXPECT_NE(key, key_of_family("p", problem, FamilyUse::truth, 250));
  EXPECT_NE(key, key_of_family("p", problem, FamilyUse::bars, 251));
  problem.impact.speed = std::nextafter(3.0, 4.0);
  EXPECT_NE(key, key_of_family("p", problem, FamilyUse::bars, 250));
}

// fine + (fine − middle)/(2^1.5 − 1): exact for errors that fall with the power 1.5.
TEST(CoverageTest, TruthIsWhereFineFamiliesGo) {
  const auto value = [](double size) { return 0.9 + 0.01 * std::pow(size, 1.5); };
  const CoverageTruth truth =
      truth_of(row(FamilyUse::truth, 2000, {value(4), value(2), value(1), value(2)}));
  EXPECT_NEAR(truth.value, 0.9, 1e-12);
  const CoverageTruth nine =
      truth_of(row(FamilyUse::nine_node, 40, {0.95, 0.92, 0.9, 0.92 + 0.003}));
  EXPECT_NEAR(nine.value, 0.904, 1e-12);
  EXPECT_NEAR(nine.error, 0.02 / 3.0 + 0.001, 1e-12);
}

TEST(CoverageTest, CountsWhatCovers) {
  std::vector<CoverageRow> rows = {row(FamilyUse::truth, 2000, {1.0, 1.0, 1.0, 1.0})};
  // Spread of the meshes, so that the bar is |fine − middle| = 0.01; errors 0.005, 0.01, 0.02.
  for (const double off : {0.005, 0.0099, 0.02})
    rows.push_back(
        row(FamilyUse::bars, 250, {1.0 + off, 1.0 + off - 0.01, 1.0 + off, 1.0 + off - 0.01}));
  const Coverage coverage = coverage_of(judge_bars(rows));
  EXPECT_EQ(coverage.bars, 3);
  EXPECT_NEAR(coverage.share, 2.0 / 3.0, 1e-12);
  EXPECT_NEAR(coverage.median_ratio, 0.01 / 0.0099, 1e-9);
  EXPECT_EQ(judge_bars(rows, "peak_force_N").size(), 0u);
}

}  // namespace
}  // namespace rebound
