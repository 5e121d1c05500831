// Blind trials as a user runs them: generator, diagnosis, scores.
#include <gtest/gtest.h>

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

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

  std::vector<std::filesystem::path> stores(const std::string& trials) const {
    std::vector<std::filesystem::path> files;
    for (const auto& entry :
         std::filesystem::directory_iterator(folder.path() / trials / "outcomes"))
      if (entry.path().extension() == ".sqlite") files.push_back(entry.path());
    return files;
  }

  /// A run in the background.
  pid_t start(const std::string& trials) const {
    const pid_t child = ::fork();
    if (child != 0) return child;
    if (::chdir(folder.path().c_str()) != 0) ::_exit(126);
    ::execl(REBOUND_PROGRAM, REBOUND_PROGRAM, "trials", trials.c_str(), "--json", nullptr);
    ::_exit(127);
  }

  /// The table, but for the time that the diagnoses took.
  std::string without_seconds(const std::string& table) const {
    std::istringstream lines(read_whole(folder.path() / table));
    std::string text, line;
    long column = -1;
    while (std::getline(lines, line)) {
      std::vector<std::string> fields;
      std::istringstream parts(line);
      for (std::string field; std::getline(parts, field, ',');) fields.push_back(field);
      if (column < 0 && !line.starts_with("#"))
        column = std::find(fields.begin(), fields.end(), "seconds") - fields.begin();
      if (column >= 0) fields.at(static_cast<std::size_t>(column)) = "";
      for (const std::string& field : fields) text += field + ",";
      text += "\n";
    }
    return text;
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
  const auto kept = stores("blind");
  ASSERT_EQ(kept.size(), 1u);
  const std::string bytes = read_whole(kept.front());
  EXPECT_EQ(rebound({"trials", "blind", "--json"}).output, first.output);
  EXPECT_EQ(read_whole(kept.front()), bytes) << "what is there is not run again";

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
  const Outcome made = run_program({.arguments = {TRIAL_GENERATOR, "--out", "slow", "--count", "3",
                                                  "--seed", "5", "--only", "pair"},
                                    .folder = folder.path()});
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  const Outcome stopped = rebound({"trials", "slow"}, {.interrupt_after_ms = 2000});
  EXPECT_EQ(stopped.exit_code, 130) << stopped.errors;
  EXPECT_NE(stopped.errors.find("kept"), std::string::npos) << stopped.errors;
  EXPECT_FALSE(there("slow/outcomes/trials.json"));
  const Outcome on = rebound({"trials", "slow", "--count", "1", "--json"});
  ASSERT_EQ(on.exit_code, 0) << on.errors;
  EXPECT_GE(nlohmann::json::parse(on.output)["outcomes"], 1);
}

// Killed at three times, while another run writes to the same store.
TEST_F(TrialsCommandTest, KilledTwiceAtATimeItLosesNothing) {
  int known = 0;
  for (int round = 0; round < 3; ++round) {
    const pid_t one = start("blind"), other = start("blind");
    std::this_thread::sleep_for(std::chrono::milliseconds(150 + 150 * round));
    for (const pid_t child : {one, other}) {
      ::kill(child, SIGKILL);
      ::waitpid(child, nullptr, 0);
    }
    const Outcome more = rebound({"trials", "blind", "--count", "1", "--json"});
    ASSERT_EQ(more.exit_code, 0) << more.errors;
    const auto json = nlohmann::json::parse(more.output);
    const int now = json["complete"] ? 6 : json["outcomes"].get<int>();
    EXPECT_GE(now, std::min(known + 1, 6)) << "an outcome is lost";
    known = now;
  }
  const Outcome whole = rebound({"trials", "blind", "--json", "--table", "killed.csv"});
  ASSERT_EQ(whole.exit_code, 0) << whole.errors;
  std::filesystem::remove_all(folder.path() / "blind" / "outcomes");
  ASSERT_EQ(rebound({"trials", "blind", "--table", "once.csv"}).exit_code, 0);
  EXPECT_EQ(without_seconds("killed.csv"), without_seconds("once.csv"));
}

TEST_F(TrialsCommandTest, AStoreThatIsDamagedOrOfAnotherVersionIsRefusedAndLeftAsItIs) {
  ASSERT_EQ(rebound({"trials", "blind", "--count", "1"}).exit_code, 0);
  const auto store = stores("blind").front();
  const std::string whole = read_whole(store);
  constexpr std::size_t version_byte = 63;
  for (const bool damaged : {true, false}) {
    std::string bytes = whole;
    if (damaged)
      bytes.resize(bytes.size() / 2);
    else
      bytes[version_byte] = 99;
    std::ofstream(store, std::ios::binary) << bytes;
    const Outcome outcome = rebound({"trials", "blind"});
    EXPECT_EQ(outcome.exit_code, 5) << outcome.errors;
    EXPECT_NE(outcome.errors.find(store.filename().string()), std::string::npos) << outcome.errors;
    EXPECT_EQ(read_whole(store), bytes);
  }
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
