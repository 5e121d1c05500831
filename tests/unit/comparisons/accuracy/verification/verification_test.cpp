// A verification suite that cannot fail shows nothing: what a wrong number does to it.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "comparisons/accuracy/verification/expected_rows.hpp"
#include "comparisons/accuracy/verification/lumped_cases.hpp"
#include "comparisons/accuracy/verification/verification_text.hpp"

namespace rebound {
namespace {

VerificationRow row(double target, double result, double tolerance, ToleranceScale scale) {
  return {.case_id = "x",
          .quantity = "q",
          .unit = "",
          .target = target,
          .result = result,
          .tolerance = tolerance,
          .scale = scale,
          .source = "s"};
}

TEST(VerificationRowTest, ToleranceHasItsScale) {
  EXPECT_TRUE(row(200.0, 201.0, 0.006, ToleranceScale::relative).passes());
  EXPECT_FALSE(row(200.0, 201.0, 0.004, ToleranceScale::relative).passes());
  EXPECT_FALSE(row(200.0, 199.0, 0.004, ToleranceScale::relative).passes());
  EXPECT_TRUE(row(0.0, -1e-7, 1e-6, ToleranceScale::absolute).passes());
  EXPECT_FALSE(row(0.0, -1e-5, 1e-6, ToleranceScale::absolute).passes());
}

TEST(VerificationRowTest, WhatIsNoNumberFails) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_FALSE(row(1.0, bad, 1.0, ToleranceScale::relative).passes());
    EXPECT_FALSE(row(1.0, bad, 1.0, ToleranceScale::absolute).passes());
  }
  EXPECT_FALSE(row(0.0, 0.0, 1.0, ToleranceScale::relative).passes());
}

TEST(VerificationRowTest, ABoundIsOneSided) {
  const auto bounded = [](double result) {
    return row(1.6, result, 0.0, ToleranceScale::upper_bound);
  };
  EXPECT_TRUE(bounded(0.0).passes());
  EXPECT_TRUE(bounded(1.6).passes());
  EXPECT_FALSE(bounded(1.61).passes());
  EXPECT_FALSE(bounded(std::numeric_limits<double>::quiet_NaN()).passes());
  EXPECT_NE(to_text({bounded(1.5)}).find("<= 1.6"), std::string::npos);
}

TEST(VerificationTest, CsvQuotesItsTexts) {
  VerificationRow one = row(1.0, 2.0, 0.1, ToleranceScale::absolute);
  one.quantity = "force, \"peak\"";
  EXPECT_NE(to_csv({one}).find("\"x\",\"force, \"\"peak\"\"\",\"\",1,2,1,0.1"), std::string::npos)
      << to_csv({one});
}

TEST(VerificationTest, OneFailureFailsTheTable) {
  VerificationTable table = {row(1.0, 1.0, 0.1, ToleranceScale::relative)};
  EXPECT_TRUE(all_pass(table));
  EXPECT_EQ(to_text(table).find("FAILS"), std::string::npos);
  table.push_back(row(1.0, 2.0, 0.1, ToleranceScale::relative));
  EXPECT_FALSE(all_pass(table));
  EXPECT_NE(to_text(table).find("FAILS"), std::string::npos);
  EXPECT_NE(to_text(table).find("1 of 2 pass"), std::string::npos);
  EXPECT_FALSE(to_json(table)["passed"]);
  EXPECT_FALSE(all_pass({}));
}

TEST(VerificationTest, LumpedCasesPassAndAllAreThere) {
  VerificationTable table = verify_lumped();
  for (VerificationRow& row : verify_estimator()) table.push_back(std::move(row));
  std::set<std::string> known_cases;
  for (const VerificationRow& row : table) {
    EXPECT_TRUE(row.passes()) << row.quantity << ": " << row.result << " for " << row.target;
    EXPECT_FALSE(row.source.empty()) << row.quantity;
    known_cases.insert(row.case_id);
  }
  EXPECT_EQ(known_cases, (std::set<std::string>{"f", "h", "published"}));
  EXPECT_GE(table.size(), 50u);
}

VerificationTable all_lumped_rows() {
  VerificationTable table = verify_lumped();
  for (const auto& part : {verify_viscoelastic_contact(), verify_estimator()})
    table.insert(table.end(), part.begin(), part.end());
  return table;
}

// The list and the suite, both ways: what is not listed would not be missed.
TEST(ExpectedRowsTest, HoldTheLumpedRowsAndNoOther) {
  const VerificationTable table = all_lumped_rows();
  EXPECT_EQ(missing_rows(table, {ExpectedRow::Tier::lumped}), std::vector<std::string>{});
  const auto of_lumped = [](const ExpectedRow& row) {
    return row.tier == ExpectedRow::Tier::lumped;
  };
  EXPECT_EQ(table.size(), static_cast<std::size_t>(std::count_if(
                              expected_rows().begin(), expected_rows().end(), of_lumped)));
}

TEST(ExpectedRowsTest, ARowThatVanishesFails) {
  VerificationTable table = all_lumped_rows();
  EXPECT_TRUE(row_of_missing(missing_rows(table, {ExpectedRow::Tier::lumped})).passes());
  const VerificationRow gone = table[7];
  table.erase(table.begin() + 7);
  const auto missing = missing_rows(table, {ExpectedRow::Tier::lumped});
  EXPECT_EQ(missing, std::vector<std::string>{gone.case_id + ": " + gone.quantity});
  EXPECT_FALSE(row_of_missing(missing).passes());
}

TEST(ExpectedRowsTest, MemoryAndFaultsAreAmongThem) {
  const auto has = [](const std::string& part) {
    return std::any_of(expected_rows().begin(), expected_rows().end(), [&](const auto& row) {
      return row.quantity.find(part) != std::string::npos;
    });
  };
  EXPECT_TRUE(has("that the memory grows with"));
  EXPECT_TRUE(has("measured memory over estimated"));
  EXPECT_TRUE(has("recorded outcome is stale"));
}

TEST(VerificationTest, JsonHasTheKeys) {
  const Json json = to_json(verify_estimator());
  EXPECT_EQ(json["schema"], 1);
  for (const char* key : {"case", "quantity", "unit", "target", "result", "deviation", "tolerance",
                          "tolerance_scale", "order", "passed", "source"})
    EXPECT_TRUE(json["rows"][0].contains(key)) << key;
}

}  // namespace
}  // namespace rebound
