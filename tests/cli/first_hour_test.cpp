#include <algorithm>
#include <filesystem>

#include "tests/cli/run_example.hpp"

namespace rebound::testing {
namespace {

class FirstHourTest : public ProgramTest {
 protected:
  /// What bash offers for a command line; the last word is the one being typed.
  std::string offered(const std::string& words) const {
    const std::string script = rebound({"completion", "bash"}).output;
    folder.write("rebound.bash", script);
    return run_program({.arguments = {"/bin/bash", "-c",
                                      "set -u; source rebound.bash; COMP_WORDS=(" + words +
                                          "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _rebound; "
                                          "printf '%s\n' \"${COMPREPLY[@]}\""},
                        .folder = folder.path()})
        .output;
  }
};

TEST_F(FirstHourTest, TheProgramAloneSaysWhatToDoNext) {
  const Outcome outcome = rebound({});
  EXPECT_EQ(outcome.exit_code, 2);
  for (const char* step : {"rebound doctor", "rebound init --out first", "rebound inspect",
                           "rebound diagnose", "--help"})
    EXPECT_NE(outcome.errors.find(step), std::string::npos) << step;
}

TEST_F(FirstHourTest, WhatItProposesToDoWorks) {
  EXPECT_EQ(rebound({"init", "--out", "first"}).exit_code, 0);
  EXPECT_EQ(rebound({"lumped", "first/lumped.toml"}).exit_code, 0);
}

TEST_F(FirstHourTest, EveryExampleIsListedWithWhatItShows) {
  const Outcome outcome = rebound({"init", "--list"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.output.find("diagnosis"), std::string::npos);
  const auto listed = nlohmann::json::parse(rebound({"init", "--list", "--json"}).output);
  EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'),
            static_cast<long>(listed.size()) - 1);  // a line each; the schema's number has none
  for (const auto& [name, shows] : listed.items())
    if (name != "schema") {
      EXPECT_GT(shows.get<std::string>().size(), 20u) << name;
    }
  EXPECT_FALSE(there("lumped.toml"));
}

TEST_F(FirstHourTest, AnExampleHasItsFilesAloneAndIsNotWrittenTwice) {
  EXPECT_EQ(rebound({"init", "calibration", "--out", "fit"}).exit_code, 0);
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "fit"))
    files.push_back(entry.path().filename().string());
  std::sort(files.begin(), files.end());
  EXPECT_EQ(files, (std::vector<std::string>{"calibrate.toml", "lumped.toml"}));
  const Outcome again = rebound({"init", "calibration", "--out", "fit"});
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_NE(again.errors.find("not overwritten"), std::string::npos) << again.errors;
}

TEST_F(FirstHourTest, AMisspeltExampleGetsTheNearOne) {
  const Outcome near = rebound({"init", "calibraton"});
  EXPECT_EQ(near.exit_code, 2);
  EXPECT_NE(near.errors.find("did you mean `rebound init calibration`?"), std::string::npos);
  const Outcome far = rebound({"init", "xyzzy"});
  EXPECT_EQ(far.exit_code, 2);
  EXPECT_EQ(far.errors.find("did you mean"), std::string::npos);
  EXPECT_NE(far.errors.find("--list"), std::string::npos) << far.errors;
  EXPECT_EQ(rebound({"init", "dataset"}).exit_code, 2);  // made from a file, which is not named
  EXPECT_EQ(rebound({"init", "lumped", "--from", "a.csv"}).exit_code, 2);
}

// Those of finite elements are run where that tier is tested; the diagnosis and the comparison
// take longest, and the test of the README runs them on the same files.
TEST_F(FirstHourTest, WhatAnExampleProposesWorks) {
  for (const char* name :
       {"lumped", "measurements", "calibration", "selection", "benchmark", "campaign"})
    run_example(folder, name);
}

TEST_F(FirstHourTest, AMisspeltCommandOrOptionGetsTheNearOne) {
  EXPECT_NE(rebound({"lumpd", "a.toml"}).errors.find("did you mean `rebound lumped`?"),
            std::string::npos);
  EXPECT_NE(rebound({"diagnos"}).errors.find("did you mean `rebound diagnose`?"),
            std::string::npos);
  EXPECT_NE(rebound({"lumped", "a.toml", "--sensitivites"})
                .errors.find("did you mean "
                             "--sensitivities?"),
            std::string::npos);
  EXPECT_EQ(rebound({"xyzzy"}).errors.find("did you mean"), std::string::npos);
}

TEST_F(FirstHourTest, BashCompletesCommandsOptionsChoicesAndFiles) {
  EXPECT_EQ(offered("rebound lum"), "lumped\n");
  EXPECT_EQ(offered("rebound lumped --sens"), "--sensitivities\n");
  EXPECT_EQ(offered("rebound completion f"), "fish\n");
  EXPECT_EQ(offered("rebound init camp"), "campaign\n");
  folder.write("mine.toml", "");
  EXPECT_EQ(offered("rebound lumped mi"), "mine.toml\n");
}

TEST_F(FirstHourTest, EveryCommandIsInEveryCompletion) {
  const std::string commands = offered("rebound ''");
  ASSERT_NE(commands.find("diagnose\n"), std::string::npos) << commands;
  for (const char* shell : {"zsh", "fish"}) {
    const std::string script = rebound({"completion", shell}).output;
    std::istringstream names(commands);
    for (std::string name; std::getline(names, name);)
      if (!name.starts_with("--")) {
        EXPECT_NE(script.find(name), std::string::npos) << shell << " " << name;
      }
    EXPECT_NE(script.find("sensitivities"), std::string::npos) << shell;
  }
}

TEST_F(FirstHourTest, AFolderOfCompletionsAndManualPagesIsWritten) {
  EXPECT_EQ(rebound({"completion", "--out", "share"}).exit_code, 0);
  for (const char* file :
       {"share/bash-completion/completions/rebound", "share/zsh/site-functions/_rebound",
        "share/fish/vendor_completions.d/rebound.fish", "share/man/man1/rebound.1",
        "share/man/man1/rebound-diagnose.1"})
    EXPECT_TRUE(there(file)) << file;
  const std::string page = read_whole(folder.path() / "share/man/man1/rebound-lumped.1");
  EXPECT_TRUE(page.starts_with(".TH \"rebound-lumped\" 1")) << page.substr(0, 80);
  for (const char* part : {".SH SYNOPSIS", "\\-\\-sensitivities", "sphere.mass", "Exit codes:"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
}

TEST_F(FirstHourTest, AShellThatIsNotKnownIsBadUsage) {
  EXPECT_EQ(rebound({"completion", "tcsh"}).exit_code, 2);
  EXPECT_EQ(rebound({"completion"}).exit_code, 2);
}

}  // namespace
}  // namespace rebound::testing
