// Other builds of the lumped tier against the program as it is: at another optimisation level of
// the compiler nothing has moved, with one sign of a law flipped it has.
#include "comparisons/accuracy/tier_comparison/baseline.hpp"
#include "comparisons/accuracy/tier_comparison/comparison.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/comparisons/accuracy/tier_comparison/lumped_cases.hpp"

#include <gtest/gtest.h>

namespace rebound {
namespace {

/// Cases as the other build runs them, against what this program records of them.
std::vector<CaseComparison> as_run_by(const char* other_build) {
  const testing::TemporaryFolder folder;
  const testing::Outcome recorded = testing::run_program(
      {.arguments = {other_build, REBOUND_TIERS_FOLDER, "."}, .folder = folder.path()});
  EXPECT_EQ(recorded.exit_code, 0) << recorded.errors;
  std::vector<CaseComparison> compared;
  for (const CompareCase& one : testing::lumped_cases())
    compared.push_back(compare_case(one, read_baseline(folder.path(), one.name),
                                    run_case(one, REBOUND_TIERS_FOLDER, {})));
  return compared;
}

TEST(TierComparisonTest, AnotherOptimisationLevelPasses) {
  for (const CaseComparison& compared : as_run_by(RECORD_UNOPTIMISED)) {
    EXPECT_EQ(compared.movements.size(), 3 * compared_keys().size());
    for (const Movement& moved : compared.movements)
      EXPECT_FALSE(moved.has_moved())
          << compared.name << " " << moved.key << " at " << moved.speed << ": " << moved.bars();
    // What rounding allows is far below what a fault of a thousandth would make.
    for (const Movement& moved : compared.movements)
      EXPECT_LT(moved.tolerance, 1e-4 * std::abs(moved.before))
          << compared.name << " " << moved.key;
  }
}

TEST(TierComparisonTest, AFlippedSignInALawIsCaughtAndPinnedToTheLumpedTier) {
  for (const CaseComparison& compared : as_run_by(RECORD_FLIPPED_SIGN)) {
    EXPECT_FALSE(compared.passes()) << compared.name;
    EXPECT_EQ(compared.moved_tiers(), std::vector<std::string>{"lumped"});
    for (const Movement& moved : compared.movements)
      if (moved.key == "restitution") {
        EXPECT_GT(std::abs(moved.bars()), 1000.0) << compared.name << " at " << moved.speed;
      }
  }
}

}  // namespace
}  // namespace rebound
