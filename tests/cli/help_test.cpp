#include "tests/cli/program.hpp"

namespace rebound::testing {
namespace {

class HelpTest : public ProgramTest {};

/// Sub-commands, read from the program's own help.
std::vector<std::string> commands_in(const std::string& help) {
  std::vector<std::string> names;
  std::istringstream lines(help.substr(help.find("Subcommands:")));
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line) && line.starts_with("  "))
    names.push_back(line.substr(2, line.find(' ', 2) - 2));
  return names;
}

TEST_F(HelpTest, EveryCommandExplainsItselfAndTheExitCodes) {
  const Outcome top = rebound({"--help"});
  EXPECT_EQ(top.exit_code, 0);
  const auto commands = commands_in(top.output);
  EXPECT_GE(commands.size(), 6u) << top.output;
  for (const std::string& command : commands) {
    const Outcome outcome = rebound({command, "--help"});
    EXPECT_EQ(outcome.exit_code, 0) << command;
    EXPECT_NE(outcome.output.find("Exit codes:"), std::string::npos) << command;
    EXPECT_NE(outcome.output.find("130"), std::string::npos) << command;
    EXPECT_EQ(outcome.output.find("Exit codes:"), outcome.output.rfind("Exit codes:")) << command;
  }
}

TEST_F(HelpTest, KeysAreListedWithUnitRangeAndSentence) {
  const std::string text = rebound({"fem", "--help"}).output;
  for (const char* part : {"sphere.mass", "value > 0 g", "Mass of the ball.",
                           "model.material.poisson_ratio", "-1 < value <= 0.499", "default 1000"})
    EXPECT_NE(text.find(part), std::string::npos) << part;
}

TEST_F(HelpTest, WrongUsageIsExitCodeTwo) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{},
                                                    {"no-such-command"},
                                                    {"lumped"},
                                                    {"lumped", "a", "b"},
                                                    {"lumped", "a", "--no-such-option"},
                                                    {"mesh"},
                                                    {"mesh", "--diameter", "66"},
                                                    {"schema", "nothing"}}) {
    const Outcome outcome = rebound(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.errors;
    EXPECT_EQ(outcome.output, "");
    EXPECT_FALSE(outcome.errors.empty());
  }
}

TEST_F(HelpTest, WrongUsageIsJsonWhenAskedFor) {
  const auto json = nlohmann::json::parse(rebound({"lumped", "--json"}).output);
  EXPECT_EQ(json["error"]["code"], 2);
}

TEST_F(HelpTest, SchemasAreJson) {
  for (const char* format : {"lumped", "fem", "dataset", "published-values", "study",
                             "calibrate-material", "diagnosis"}) {
    const auto json = nlohmann::json::parse(rebound({"schema", format}).output);
    EXPECT_EQ(json["type"], "object");
    EXPECT_TRUE(json["properties"].contains("schema"));
  }
}

}  // namespace
}  // namespace rebound::testing
