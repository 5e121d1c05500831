// The coverage campaign on a store of results: killed, run twice at a time, and continued.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/run_program.hpp"
#include "tests/support/temporary_folder.hpp"

namespace rebound::testing {
namespace {

class CoverageCampaign : public ::testing::Test {
 protected:
  Outcome run(const std::string& store, const std::string& table) const {
    return run_program(
        {.arguments = {COVERAGE_CAMPAIGN, store, table, "--try"}, .folder = folder.path()});
  }

  pid_t start(const std::string& store, const std::string& table) const {
    const pid_t child = ::fork();
    if (child != 0) return child;
    if (::chdir(folder.path().c_str()) != 0) ::_exit(126);
    ::execl(COVERAGE_CAMPAIGN, COVERAGE_CAMPAIGN, store.c_str(), table.c_str(), "--try", nullptr);
    ::_exit(127);
  }

  TemporaryFolder folder;
};

TEST_F(CoverageCampaign, KilledAndTwiceAtATimeItGivesTheSameTable) {
  const Outcome whole = run("whole.sqlite", "whole.csv");
  ASSERT_EQ(whole.exit_code, 0) << whole.errors;
  EXPECT_NE(whole.output.find("0 found in the store, 3 run, 0 of all failed"), std::string::npos)
      << whole.output;
  const std::string table = read_whole(folder.path() / "whole.csv");
  for (const int wait_ms : {50, 400, 900}) {
    const pid_t one = start("shared.sqlite", "one.csv"), other = start("shared.sqlite", "two.csv");
    std::this_thread::sleep_for(std::chrono::milliseconds(wait_ms));
    for (const pid_t child : {one, other}) {
      ::kill(child, SIGKILL);
      ::waitpid(child, nullptr, 0);
    }
  }
  ASSERT_EQ(run("shared.sqlite", "shared.csv").exit_code, 0);
  EXPECT_EQ(read_whole(folder.path() / "shared.csv"), table);
  const Outcome again = run("shared.sqlite", "again.csv");
  EXPECT_NE(again.output.find("3 found in the store, 0 run"), std::string::npos) << again.output;
  EXPECT_EQ(read_whole(folder.path() / "again.csv"), table);
  const Outcome known = run("new.sqlite", "again.csv");
  EXPECT_NE(known.output.find("3 families in the table before, 0 found in the store, 0 run"),
            std::string::npos)
      << known.output;
  EXPECT_EQ(read_whole(folder.path() / "again.csv"), table) << "what a table has is not run again";
}

// The table grows with each family: stopped after the first, and once by a kill, it holds what was
// complete, and is that of a run in one go once the rest is there, whatever store that is.
TEST_F(CoverageCampaign, StoppedItHasWhatWasCompleteInItsTable) {
  ASSERT_EQ(run("whole.sqlite", "whole.csv").exit_code, 0);
  const std::string whole = read_whole(folder.path() / "whole.csv");
  for (const int signal : {SIGINT, SIGTERM, SIGKILL}) {
    const std::string name = std::to_string(signal);
    const pid_t child = start(name + ".sqlite", name + ".csv");
    const auto table = folder.path() / (name + ".csv");
    for (int i = 0; i < 6000 && !std::filesystem::exists(table); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ::kill(child, signal);
    int status = 0;
    ::waitpid(child, &status, 0);
    if (signal == SIGKILL)
      EXPECT_TRUE(WIFSIGNALED(status));
    else
      EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 130) << status;
    const std::string part = read_whole(table);
    EXPECT_GT(part.size(), part.find('\n') + 1) << "no family but the heading";
    EXPECT_LT(part.size(), whole.size()) << "it was done before the signal";
    std::istringstream lines(part);
    for (std::string line; std::getline(lines, line);)
      EXPECT_NE(whole.find(line + "\n"), std::string::npos) << line;
    ASSERT_EQ(run("other-" + name + ".sqlite", name + ".csv").exit_code, 0);
    EXPECT_EQ(read_whole(table), whole);
  }
}

/// Heading of the stored table, and of its first point the truth and the family from 250 cells.
std::vector<std::string> one_family() {
  std::istringstream stored(read_whole(COVERAGE_TABLE));
  std::vector<std::string> lines(1);
  std::getline(stored, lines.front());
  for (std::string line; std::getline(stored, line);)
    if (line.starts_with("1,") &&
        (line.find(",truth,") != std::string::npos || line.find(",bars,250,") != std::string::npos))
      lines.push_back(line);
  return lines;
}

// As it stands, and with restitutions a thousandth below those of its runs.
TEST_F(CoverageCampaign, AgainSaysWhatTheProgramMakesOfAStoredFamily) {
  const auto again = [&](const std::vector<std::string>& lines) {
    std::string table;
    for (const std::string& line : lines) table += line + "\n";
    folder.write("table.csv", table);
    const Outcome outcome = run_program(
        {.arguments = {COVERAGE_CAMPAIGN, "--again", "table.csv"}, .folder = folder.path()});
    EXPECT_EQ(read_whole(folder.path() / "table.csv"), table) << "it writes nothing";
    return outcome;
  };
  std::vector<std::string> lines = one_family();
  ASSERT_EQ(lines.size(), 11u);  // five scalars each
  const Outcome same = again(lines);
  EXPECT_EQ(same.exit_code, 0) << same.output << same.errors;
  EXPECT_NE(same.output.find("; 0 verdicts differ"), std::string::npos) << same.output;
  for (std::string& line : lines)
    if (line.find(",bars,250,restitution,") != std::string::npos)
      for (auto at = line.find("0.998"); at != std::string::npos; at = line.find("0.998"))
        line.replace(at, 5, "0.997");
  const Outcome moved = again(lines);
  EXPECT_EQ(moved.exit_code, 1) << moved.output << moved.errors;
  EXPECT_NE(moved.output.find("; 1 verdicts differ"), std::string::npos) << moved.output;
}

TEST_F(CoverageCampaign, ADamagedStoreIsRefusedAndLeftAsItIs) {
  folder.write("no.sqlite", "SQLite format 3 it is not");
  const Outcome outcome = run("no.sqlite", "table.csv");
  EXPECT_EQ(outcome.exit_code, 5);
  EXPECT_NE(outcome.errors.find("no.sqlite"), std::string::npos) << outcome.errors;
  EXPECT_EQ(read_whole(folder.path() / "no.sqlite"), "SQLite format 3 it is not");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "table.csv"));
}

}  // namespace
}  // namespace rebound::testing
