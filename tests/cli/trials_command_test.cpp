// Blind trials as a user runs them: generator, diagnosis, scores.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/cli/program.hpp"

namespace rebound::testing {
namespace {

class TrialsCommandTest : public ProgramTest {
 protected:
  void SetUp() override {
    const Outcome made = run_program({.arguments = {TRIAL_GENERATOR, "--out", "blind", "--count",
                                                    "6", "--seed", "3", "--only", "null"},
                                      .folder = folder.path()});
    ASSERT_EQ(made.exit_code, 0) << made.errors;
  }
};

TEST_F(TrialsCommandTest, NullsAreScoredAndOutcomesAreKept) {
  const Outcome first = rebound({"trials", "blind", "--json"});
  ASSERT_EQ(first.exit_code, 0) << first.errors;
  const auto json = nlohmann::json::parse(first.output);
  EXPECT_EQ(json["trials"], 6);
  EXPECT_EQ(json["gates"][0]["what"], "false alarms on nulls");
  EXPECT_EQ(json["gates"][0]["of"], 6);
  EXPECT_LE(json["gates"][0]["count"], 2);
  EXPECT_TRUE(there("blind/outcomes/trials.json"));
  EXPECT_TRUE(there("blind/outcomes/report.html"));
  const auto outcome = folder.path() / "blind" / "outcomes" / "0003.json";
  const auto written = std::filesystem::last_write_time(outcome);
  EXPECT_EQ(rebound({"trials", "blind", "--json"}).exit_code, 0);
  EXPECT_EQ(std::filesystem::last_write_time(outcome), written) << "what is there is not run again";

  std::ofstream(folder.path() / "blind" / "truth" / "0001.json", std::ios::app) << " ";
  const Outcome changed = rebound({"trials", "blind"});
  EXPECT_EQ(changed.exit_code, 5);
  EXPECT_NE(changed.errors.find("sealed"), std::string::npos) << changed.errors;
}

TEST_F(TrialsCommandTest, AFolderWithoutTrialsIsRefused) {
  const Outcome outcome = rebound({"trials", "nowhere"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.errors.find("trial_generator"), std::string::npos) << outcome.errors;
}

}  // namespace
}  // namespace rebound::testing
