#include "comparisons/studies/reproduce/repair_search.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rebound {
namespace {

PrintedNumber printed(double value, double unit) {
  return {unit * std::round(value / unit), 0.5 * unit};
}

/// y = a √b/c² of six rows; a per row, b per group, c a constant.
struct Table {
  std::vector<double> a{1.00, 1.37, 2.05, 2.91, 4.44, 5.83};
  std::vector<double> b_used, c_used, a_used;
  double b_printed = 7.30, c_printed = 1.25;

  static double formula(const std::vector<double>& in) {
    return in[0] * std::sqrt(in[1]) / (in[2] * in[2]);
  }
  Block block() const {
    Block block{"toy", {}};
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double y = formula({a_used.empty() ? a[i] : a_used[i], b_used[i], c_used[i]});
      block.rows.push_back({.key = {.table = "toy",
                                    .core = i < 3 ? "A" : "B",
                                    .speed = 1.0 + i % 3,
                                    .quantity = "y",
                                    .unit = "1"},
                            .published = printed(y, 1e-3),
                            .inputs = {{"a", "row", printed(a[i], 1e-2)},
                                       {"b", "all", printed(b_printed, 1e-2)},
                                       {"c", "all", exactly(c_printed)}},
                            .formula = formula});
    }
    return block;
  }
};

TEST(RepairSearchTest, NothingIsLookedForWhereNothingDiffers) {
  Table table;
  table.b_used.assign(6, 7.30);
  table.c_used.assign(6, 1.25);
  const BlockSearch search = search_repairs(table.block());
  EXPECT_EQ(search.differing, 0u);
  EXPECT_TRUE(search.repairs.empty());
}

TEST(RepairSearchTest, FindsAPlantedWrongInput) {
  Table table;
  table.b_used.assign(6, 8.10);  // instead of the printed 7.30
  table.c_used.assign(6, 1.25);
  const BlockSearch search = search_repairs(table.block());
  EXPECT_EQ(search.differing, 6u);
  ASSERT_FALSE(search.repairs.empty());
  bool found = false;
  for (const Repair& repair : search.repairs)
    found = found || (repair.input == "b" && repair.needed.low <= 8.10 &&
                      8.10 <= repair.needed.high && repair.to_the_digit == 6);
  EXPECT_TRUE(found);
}

TEST(RepairSearchTest, FindsAPlantedFactor) {
  Table table;
  table.b_used.assign(6, 7.30);
  table.c_used.assign(6, 1.25);
  for (const double a : table.a) table.a_used.push_back(2.0 * a);  // a diameter for a radius
  const BlockSearch search = search_repairs(table.block());
  bool found = false;
  for (const Repair& repair : search.repairs)
    found = found || (repair.input == "a" && repair.change == Change::common_factor &&
                      repair.needed.low <= 2.0 && 2.0 <= repair.needed.high);
  EXPECT_TRUE(found);
}

TEST(RepairSearchTest, TwoWrongInputsHaveNoRepair) {
  Table table;  // b wrong in the first half, c in the second, in opposite senses
  table.b_used = {8.10, 8.10, 8.10, 7.30, 7.30, 7.30};
  table.c_used = {1.25, 1.25, 1.25, 1.41, 1.41, 1.41};
  const BlockSearch search = search_repairs(table.block());
  EXPECT_EQ(search.differing, 6u);
  EXPECT_TRUE(search.repairs.empty());
  EXPECT_LT(search.nearest.repaired, 6u);
  EXPECT_GE(search.nearest.repaired, 3u);
}

TEST(RepairSearchTest, ATableThatOnlyItsPartsRepairIsSearchedByCore) {
  Table table;
  table.b_used = {8.10, 8.10, 8.10, 6.20, 6.20, 6.20};  // one wrong value per core
  table.c_used.assign(6, 1.25);
  const auto searches = search_table(table.block().rows);
  ASSERT_EQ(searches.size(), 3u);
  EXPECT_EQ(searches[0].block, "toy");
  EXPECT_TRUE(searches[0].repairs.empty());
  EXPECT_EQ(searches[1].block, "toy, core A");
  EXPECT_EQ(searches[2].block, "toy, core B");
  EXPECT_FALSE(searches[1].repairs.empty());
  EXPECT_FALSE(searches[2].repairs.empty());
}

TEST(AcceptedValuesTest, EndsAreThoseOfTheClosedForm) {
  // y = a²: published 9 ± 0.5 asks for a between √8.5 and √9.5.
  const DerivedRow row{.key = {.unit = "1"},
                       .published = {9.0, 0.5},
                       .inputs = {{"a", "all", {4.0, 0.5}}},
                       .formula = [](const std::vector<double>& in) { return in[0] * in[0]; }};
  const auto accepted = accepted_values(row, 0, Strictness::within_rounding);
  ASSERT_EQ(accepted.size(), 1u);
  EXPECT_NEAR(accepted[0].low, std::sqrt(8.5), 1e-12);
  EXPECT_NEAR(accepted[0].high, std::sqrt(9.5), 1e-12);
}

TEST(AcceptedValuesTest, FindsBothBranchesOfATurningFormula) {
  // y = a + 4/a has its least value 4 at a = 2; 5 ± 0.001 is met near 1 and near 4.
  const DerivedRow row{
      .key = {.unit = "1"},
      .published = {5.0, 1e-3},
      .inputs = {{"a", "all", exactly(2.1)}},
      .formula = [](const std::vector<double>& in) { return in[0] + 4.0 / in[0]; }};
  const auto accepted = accepted_values(row, 0, Strictness::within_rounding);
  ASSERT_EQ(accepted.size(), 2u);
  EXPECT_TRUE(accepted[0].low < 1.0 && 1.0 < accepted[0].high);
  EXPECT_TRUE(accepted[1].low < 4.0 && 4.0 < accepted[1].high);
}

}  // namespace
}  // namespace rebound
