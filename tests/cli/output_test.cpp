#include <algorithm>
#include <iterator>
#include <sstream>

#include "tests/cli/program.hpp"

namespace rebound::testing {
namespace {

class OutputTest : public ProgramTest {
 protected:
  void SetUp() override {
    folder.write("a.toml", lumped_file);
    // An unprivileged user must get here and read the file.
    std::filesystem::permissions(folder.path(), std::filesystem::perms(0755));
  }
};

TEST_F(OutputTest, AFolderThatCannotBeWrittenIsExitCodeFour) {
  std::filesystem::create_directory(folder.path() / "locked");
  std::filesystem::permissions(folder.path() / "locked", std::filesystem::perms(0555));
  for (const char* out : {"locked", "locked/inner", "a.toml"}) {
    const Outcome outcome =
        rebound({"lumped", "a.toml", "--out", out}, {.privileges = Privileges::drop});
    EXPECT_EQ(outcome.exit_code, 4) << out << outcome.errors;
    EXPECT_NE(outcome.errors.find(out), std::string::npos) << outcome.errors;
    EXPECT_EQ(outcome.output, "");
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path() / "locked"));
}

TEST_F(OutputTest, AFullDiskIsExitCodeFourAndLeavesNoTrace) {
  const Outcome outcome = rebound({"lumped", "a.toml", "--out", "results"}, {.largest_file = 4096});
  EXPECT_EQ(outcome.exit_code, 4) << outcome.errors;
  EXPECT_FALSE(there("results/trace.csv"));
  EXPECT_FALSE(there("results/result.json"));
}

TEST_F(OutputTest, NoTemporaryFileStays) {
  ASSERT_EQ(rebound({"lumped", "a.toml", "--out", "results"}).exit_code, 0);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "results"))
    EXPECT_EQ(entry.path().string().find("partial"), std::string::npos) << entry.path();
}

TEST_F(OutputTest, DoctorFindsNothingWrong) {
  const Outcome outcome = rebound({"doctor", "--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_EQ(nlohmann::json::parse(outcome.output)["healthy"], true);
}

/// A terminal ends lines by two characters.
std::string at_terminal(const Outcome& shown) {
  std::string text;
  for (const char c : shown.output)
    if (c != '\r') text += c;
  return text;
}

std::size_t longest_line(const std::string& text) {
  std::istringstream lines(text);
  std::size_t longest = 0;
  for (std::string line; std::getline(lines, line);) longest = std::max(longest, line.size());
  return longest;
}

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

TEST_F(OutputTest, WhatIsReadFollowsTheTerminalAndIsPlainInAPipe) {
  const auto shown = [&](const std::string& command) {
    const std::string line = "stty cols 60; " + std::string(REBOUND_PROGRAM) + " " + command;
    return at_terminal(run_program(
        {.arguments = {"/usr/bin/script", "-qec", line, "/dev/null"}, .folder = folder.path()}));
  };
  const std::string piped = rebound({"init", "--list"}).output;
  ASSERT_GT(longest_line(piped), 60u);
  const std::string narrow = shown("init --list");
  EXPECT_LE(longest_line(narrow), 60u) << narrow;
  EXPECT_EQ(words_of(narrow), words_of(piped));
  // What programs read stays as it is.
  EXPECT_EQ(shown("init --list --json"), rebound({"init", "--list", "--json"}).output);
}

TEST_F(OutputTest, AShareIsPrintedInPerCentBesideItsNumber) {
  const Outcome outcome = rebound({"lumped", "a.toml"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const double share = nlohmann::json::parse(
      rebound({"lumped", "a.toml", "--json"}).output)["kinetic_energy_loss_share"];
  std::istringstream lines(outcome.output);
  std::string key, number, per_cent, sign;
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("kinetic_energy_loss_share"))
      std::istringstream(line) >> key >> number >> per_cent >> sign;
  EXPECT_NEAR(std::stod(number), share, 1e-5 * share);
  EXPECT_NEAR(std::stod(per_cent), 100.0 * share, 0.06);
  EXPECT_EQ(sign, "%");
}

}  // namespace
}  // namespace rebound::testing
