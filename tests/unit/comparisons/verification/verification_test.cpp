// A ladder that cannot fail shows nothing: what a wrong number does to it.
#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "comparisons/verification/lumped_rungs.hpp"
#include "comparisons/verification/verification_text.hpp"

namespace rebound {
namespace {

VerificationRow row(double target, double result, double tolerance, ToleranceScale scale) {
  return {.rung = "x", .quantity = "q", .unit = "", .target = target, .result = result,
          .tolerance = tolerance, .scale = scale, .source = "s"};
}

TEST(VerificationRowTest, ToleranceHasItsScale) {
  EXPECT_TRUE(row(200.0, 201.0, 0.006, ToleranceScale::relative).passes());
  EXPECT_FALSE(row(200.0, 201.0, 0.004, ToleranceScale::relative).passes());
  EXPECT_FALSE(row(200.0, 199.0, 0.004, ToleranceScale::relative).passes());
  EXPECT_TRUE(row(0.0, -1e-7, 1e-6, ToleranceScale::absolute).passes());
  EXPECT_FALSE(row(0.0, -1e-5, 1e-6, ToleranceScale::absolute).passes());
}

TEST(VerificationRowTest, WhatIsNoNumberFails) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity()}) {
    EXPECT_FALSE(row(1.0, bad, 1.0, ToleranceScale::relative).passes());
    EXPECT_FALSE(row(1.0, bad, 1.0, ToleranceScale::absolute).passes());
  }
  EXPECT_FALSE(row(0.0, 0.0, 1.0, ToleranceScale::relative).passes());
}

TEST(VerificationRowTest, ABoundIsOneSided) {
  const auto bounded = [](double result) { return row(1.6, result, 0.0, ToleranceScale::upper_bound); };
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

TEST(VerificationTest, LumpedRungsPassAndAllAreThere) {
  VerificationTable table = verify_lumped();
  for (VerificationRow& row : verify_estimator()) table.push_back(std::move(row));
  std::set<std::string> rungs;
  for (const VerificationRow& row : table) {
    EXPECT_TRUE(row.passes()) << row.quantity << ": " << row.result << " for " << row.target;
    EXPECT_FALSE(row.source.empty()) << row.quantity;
    rungs.insert(row.rung);
  }
  EXPECT_EQ(rungs, (std::set<std::string>{"f", "h", "published"}));
  EXPECT_GE(table.size(), 50u);
}

TEST(VerificationTest, JsonHasTheKeys) {
  const Json json = to_json(verify_estimator());
  EXPECT_EQ(json["schema"], 1);
  for (const char* key : {"rung", "quantity", "unit", "target", "result", "deviation", "tolerance",
                          "tolerance_scale", "order", "passed", "source"})
    EXPECT_TRUE(json["rows"][0].contains(key)) << key;
}

}  // namespace
}  // namespace rebound
