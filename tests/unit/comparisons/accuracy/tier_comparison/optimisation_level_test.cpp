// The same sources at another optimisation level of the compiler: nothing has moved.
#include "comparisons/accuracy/tier_comparison/baseline.hpp"
#include "comparisons/accuracy/tier_comparison/comparison.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/comparisons/accuracy/tier_comparison/lumped_cases.hpp"

#include <gtest/gtest.h>

namespace rebound {
namespace {

TEST(TierComparisonTest, AnotherOptimisationLevelPasses) {
  const testing::TemporaryFolder folder;
  const testing::Outcome recorded = testing::run_program(
      {.arguments = {RECORD_UNOPTIMISED, REBOUND_TIERS_FOLDER, "."}, .folder = folder.path()});
  ASSERT_EQ(recorded.exit_code, 0) << recorded.errors;
  for (const CompareCase& one : testing::lumped_cases()) {
    const auto now = run_case(one, REBOUND_TIERS_FOLDER, {});
    const auto before = read_baseline(folder.path(), one.name);
    const CaseComparison compared = compare_case(one, now, before);
    EXPECT_EQ(compared.movements.size(), 3 * compared_keys().size());
    for (const Movement& moved : compared.movements)
      EXPECT_FALSE(moved.has_moved())
          << one.name << " " << moved.key << " at " << moved.speed << ": " << moved.bars();
    // What rounding allows is far below what a fault of a thousandth would make.
    for (const Movement& moved : compared.movements)
      EXPECT_LT(moved.tolerance, 1e-4 * std::abs(moved.before)) << one.name << " " << moved.key;
  }
}

}  // namespace
}  // namespace rebound
