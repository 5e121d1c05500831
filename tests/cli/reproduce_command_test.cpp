#include "tests/cli/program.hpp"

namespace rebound::testing {
namespace {

class ReproduceCommandTest : public ProgramTest {};

TEST_F(ReproduceCommandTest, PrintsTheContractsKeysAndNothingElse) {
  const Outcome outcome = rebound({"reproduce", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors, "");
  const auto json = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(json["schema"], 1);
  ASSERT_GE(json["rows"].size(), 76u);  // Tables 2 to 5 alone
  for (const auto& row : json["rows"]) {
    const std::string verdict = row["verdict"];
    const double computed = row["computed"], low = row["low"], high = row["high"];
    EXPECT_TRUE(verdict == "reproduces" || verdict == "within-rounding" || verdict == "differs");
    EXPECT_TRUE(low <= computed && computed <= high) << row.dump();
  }
  for (const auto& finding : json["findings"])
    for (const char* key : {"id", "statement", "evidence"}) EXPECT_TRUE(finding[key].is_string());
}

TEST_F(ReproduceCommandTest, WritesItsNumbersAndAReport) {
  ASSERT_EQ(rebound({"reproduce", "--out", "results"}).exit_code, 0);
  const auto json = nlohmann::json::parse(read_whole(folder.path() / "results/reproduce.json"));
  EXPECT_EQ(json["provenance"]["input_sha256"].get<std::string>().size(), 64u);
  EXPECT_NE(read_whole(folder.path() / "results/report.html").find("</html>"), std::string::npos);
}

TEST_F(ReproduceCommandTest, AMissingDataFolderIsAReadingError) {
  const Outcome outcome = rebound({"reproduce", "--json", "--data", "nowhere"});
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_EQ(nlohmann::json::parse(outcome.output)["error"]["code"], 4);
}

}  // namespace
}  // namespace rebound::testing
