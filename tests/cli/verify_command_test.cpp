#include "tests/cli/program.hpp"

namespace rebound::testing {
namespace {

class VerifyCommandTest : public ProgramTest {};

TEST_F(VerifyCommandTest, LumpedCasesPassAsTextAndJson) {
  const Outcome text = rebound({"verify", "--tier", "lumped"});
  EXPECT_EQ(text.exit_code, 0) << text.errors;
  EXPECT_NE(text.output.find("Kuwabara-Kono"), std::string::npos);
  const Outcome outcome = rebound({"verify", "--tier", "lumped", "--json", "--out", "results"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const auto json = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(json["schema"], 1);
  EXPECT_TRUE(json["passed"]);
  EXPECT_GT(json["rows"].size(), 50u);
  const auto stored = nlohmann::json::parse(read_whole(folder.path() / "results/verify.json"));
  EXPECT_EQ(stored["rows"], json["rows"]);
  EXPECT_TRUE(there("results/report.html"));
}

TEST_F(VerifyCommandTest, AnUnknownTierIsBadUsage) {
  EXPECT_EQ(rebound({"verify", "--tier", "experiment"}).exit_code, 2);
}

TEST_F(VerifyCommandTest, FemCasesPass) {
  const Outcome outcome = rebound({"verify", "--tier", "fem", "--json", "--out", "results"});
  const auto json = nlohmann::json::parse(outcome.output);
  for (const auto& row : json["rows"]) EXPECT_TRUE(row["passed"]) << row.dump();
  EXPECT_NE(read_whole(folder.path() / "results/report.html").find("Ripple of the force"),
            std::string::npos);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
}

}  // namespace
}  // namespace rebound::testing
