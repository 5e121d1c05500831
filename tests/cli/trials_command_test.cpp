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
  const Outcome part = rebound({"trials", "blind", "--count", "2", "--json"});
  ASSERT_EQ(part.exit_code, 0) << part.errors;
  EXPECT_EQ(nlohmann::json::parse(part.output)["outcomes"], 2);
  EXPECT_FALSE(there("blind/outcomes/trials.json")) << "no truth before the last outcome";
  const Outcome first = rebound({"trials", "blind", "--json", "--table", "table.csv"});
  ASSERT_EQ(first.exit_code, 0) << first.errors;
  const auto json = nlohmann::json::parse(first.output);
  EXPECT_EQ(json["trials"], 6);
  EXPECT_EQ(json["gates"][0]["what"], "false alarms on nulls");
  EXPECT_EQ(json["gates"][0]["of"], 6);
  EXPECT_LE(json["gates"][0]["count"], 2);
  EXPECT_EQ(json["protocols"].size(), 1u);
  EXPECT_GE(json["controls"]["random"][0]["count"], 3) << "one answer of eight is the right one";
  EXPECT_TRUE(there("blind/outcomes/trials.json"));
  EXPECT_TRUE(there("blind/outcomes/report.html"));
  const auto outcome = folder.path() / "blind" / "outcomes" / "0003.json";
  const auto written = std::filesystem::last_write_time(outcome);
  EXPECT_EQ(rebound({"trials", "blind", "--json"}).exit_code, 0);
  EXPECT_EQ(std::filesystem::last_write_time(outcome), written) << "what is there is not run again";

  const Outcome again = rebound({"trials", "--from-table", "table.csv", "--json", "--out", "page"});
  EXPECT_EQ(again.output, first.output) << "the table holds all that scores are made of";
  EXPECT_TRUE(there("page/report.html"));

  std::filesystem::copy(folder.path() / "blind", folder.path() / "copy",
                        std::filesystem::copy_options::recursive);
  const Outcome twice = rebound({"trials", "blind", "copy"});
  EXPECT_EQ(twice.exit_code, 2);
  EXPECT_NE(twice.errors.find("two folders"), std::string::npos) << twice.errors;
  const Outcome more = run_program({.arguments = {TRIAL_GENERATOR, "--out", "more", "--count", "2",
                                                  "--seed", "4", "--only", "null"},
                                    .folder = folder.path()});
  ASSERT_EQ(more.exit_code, 0) << more.errors;
  const Outcome together = rebound({"trials", "blind", "more", "--json"});
  ASSERT_EQ(together.exit_code, 0) << together.errors;
  EXPECT_EQ(nlohmann::json::parse(together.output)["gates"][0]["of"], 8);
  EXPECT_TRUE(there("results/trials/report.html"));

  std::ofstream(folder.path() / "blind" / "truth" / "0001.json", std::ios::app) << " ";
  const Outcome changed = rebound({"trials", "blind"});
  EXPECT_EQ(changed.exit_code, 5);
  EXPECT_NE(changed.errors.find("sealed"), std::string::npos) << changed.errors;
}

TEST_F(TrialsCommandTest, ATableAndFoldersAreNotTakenTogether) {
  EXPECT_EQ(rebound({"trials", "blind", "--from-table", "table.csv"}).exit_code, 2);
  EXPECT_EQ(rebound({"trials"}).exit_code, 2);
  EXPECT_EQ(rebound({"trials", "--from-table", "none.csv"}).exit_code, 4);
}

TEST_F(TrialsCommandTest, AnInterruptedRunGoesOnWhereItWas) {
  const Outcome made = run_program({.arguments = {TRIAL_GENERATOR, "--out", "slow", "--count", "8",
                                                  "--seed", "5", "--only", "pair"},
                                    .folder = folder.path()});
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  const Outcome stopped = rebound({"trials", "slow"}, {.interrupt_after_ms = 2000});
  EXPECT_EQ(stopped.exit_code, 130) << stopped.errors;
  EXPECT_NE(stopped.errors.find("goes on"), std::string::npos) << stopped.errors;
  EXPECT_FALSE(there("slow/outcomes/trials.json"));
  std::vector<std::filesystem::path> kept;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "slow/outcomes"))
    if (entry.path().filename().string().starts_with("000")) kept.push_back(entry.path());
  const Outcome on = rebound({"trials", "slow", "--count", "1", "--json"});
  ASSERT_EQ(on.exit_code, 0) << on.errors;
  EXPECT_EQ(nlohmann::json::parse(on.output)["outcomes"], kept.size() + 1);
}

// Twenty trials of all kinds: 6 nulls, 8 single effects that show. Rates are loose, for so few;
// those of many are in the README of the room.
TEST(TrialsSmallSetTest, MostFamiliesAreRightAndNamesAreSeldomWrong) {
  const TemporaryFolder folder;
  const Outcome made = run_program({.arguments = {TRIAL_GENERATOR, "--out", "t", "--count", "20",
                                                  "--seed", "11", "--set", "calibration"},
                                    .folder = folder.path()});
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  const Outcome outcome = run_program(
      {.arguments = {REBOUND_PROGRAM, "trials", "t", "--json"}, .folder = folder.path()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const auto json = nlohmann::json::parse(outcome.output);
  const auto count_of = [](const nlohmann::json& gates, const std::string& what) {
    for (const auto& gate : gates)
      if (gate["what"] == what) return gate["count"].get<int>();
    throw std::runtime_error("no gate " + what);
  };
  const auto& gates = json["gates"];
  EXPECT_LE(count_of(gates, "false alarms on nulls"), 1);
  EXPECT_GE(count_of(gates, "family right"), 5);
  EXPECT_LE(count_of(gates, "wrong family"), 2);
  EXPECT_LE(count_of(gates, "confidently wrong name"), 1);
  for (const char* control : {"lowest-information-criterion", "sparse-regression", "random"}) {
    const auto& other = json["controls"][control];
    // Of eight, one is chance.
    EXPECT_GE(count_of(gates, "family right") + 1, count_of(other, "family right")) << control;
    EXPECT_LE(
        count_of(gates, "confidently wrong name") + count_of(gates, "false alarms on nulls"),
        1 + count_of(other, "confidently wrong name") + count_of(other, "false alarms on nulls"))
        << control;
  }
}

TEST_F(TrialsCommandTest, AFolderWithoutTrialsIsRefused) {
  const Outcome outcome = rebound({"trials", "nowhere"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.errors.find("trial_generator"), std::string::npos) << outcome.errors;
}

}  // namespace
}  // namespace rebound::testing
