// `compare` as a user meets it: what moves is caught, pinned to its tier, and nothing else fails.
#include "tests/cli/program.hpp"

namespace rebound::testing {
namespace {

const std::string compare_file = R"(schema = 1
[[case]]
name = "ball"
lumped = "lumped.toml"
fem = "fem.toml"
speeds = ["5 m/s", "15 m/s"]
)";

const std::string linear_file = R"(schema = 1
[impact]
speed = "15 m/s"
separation = "zero-force"
[sphere]
mass = "89.6 g"
diameter = "66.2 mm"
[model]
tier = "lumped"
law = "linear-kelvin-voigt"
stiffness = "2.5e5 N/m"
damping = "60 N.s/m"
)";

class CompareCommand : public ProgramTest {
 protected:
  void SetUp() override {
    folder.write("compare.toml", compare_file);
    folder.write("lumped.toml", linear_file);
    folder.write("fem.toml", fem_file);
  }
  Outcome compare(const std::vector<std::string>& further, Invocation run = {}) const {
    std::vector<std::string> arguments{"compare", "compare.toml", "--baseline", "base"};
    arguments.insert(arguments.end(), further.begin(), further.end());
    return rebound(arguments, std::move(run));
  }
  void record() const { ASSERT_EQ(compare({"--record"}).exit_code, 0); }
  nlohmann::json compared() const {
    return nlohmann::json::parse(compare({"--json"}).output)["cases"][0];
  }
};

using Names = std::vector<std::string>;

TEST_F(CompareCommand, TheSameProgramPassesOnEveryKernel) {
  record();
  EXPECT_EQ(compare({}).exit_code, 0);
  const Outcome slow = compare({}, {.environment = {"REBOUND_KERNEL=baseline"}});
  EXPECT_EQ(slow.exit_code, 0) << slow.output;
}

TEST_F(CompareCommand, AModulusOfOnePerCentMoreIsPinnedToFe) {
  record();
  folder.write("fem.toml", replaced(fem_file, "10 MPa", "10.1 MPa"));
  EXPECT_EQ(compare({}).exit_code, 1);
  const auto moved = compared();
  EXPECT_EQ(moved["moved_tiers"].get<Names>(), Names{"fem"});
  double largest = 0.0;
  for (const auto& one : moved["movements"])
    if (one["key"] == "peak_deflection_m" && one["tier"] == "fem") {
      EXPECT_TRUE(one["moved"]) << one;
      largest = std::max(largest, std::abs(one["bars"].get<double>()));
    }
  EXPECT_GT(largest, 10.0);
}

TEST_F(CompareCommand, AnotherSeparationRuleIsPinnedToTheLumpedTierAndSaid) {
  record();
  folder.write("lumped.toml", replaced(linear_file, "zero-force", "zero-deflection"));
  const Outcome outcome = compare({});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.output.find("contact ends by zero-deflection, in the baseline by zero-force"),
            std::string::npos)
      << outcome.output;
  EXPECT_EQ(compared()["moved_tiers"].get<Names>(), Names{"lumped"});
}

TEST_F(CompareCommand, AFinerMeshPassesWithinTheNumericalError) {
  record();
  folder.write("fem.toml", replaced(fem_file, "cells = 60", "cells = 90"));
  const Outcome outcome = compare({});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_NE(outcome.output.find("compared within the numerical error"), std::string::npos);
}

TEST_F(CompareCommand, AnotherToleranceOfTheIntegratorPasses) {
  record();
  folder.write("lumped.toml", linear_file + "[controls]\nrelative_tolerance = 1e-11\n");
  const Outcome outcome = compare({});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
}

TEST_F(CompareCommand, AGapBeyondWhatTheCaseAllowsFails) {
  folder.write("compare.toml", compare_file + "[case.agreement]\nrestitution = 0.001\n");
  const Outcome outcome = rebound({"compare", "compare.toml", "--out", "page"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.output.find("BEYOND what is allowed"), std::string::npos);
  EXPECT_TRUE(there("page/report.html"));
  EXPECT_TRUE(there("page/comparison.json"));
}

TEST_F(CompareCommand, BadInputIsRefusedAndACorruptBaselineSaid) {
  EXPECT_EQ(compare({}).exit_code, 2);  // no baseline yet
  record();
  const std::string whole = read_whole(folder.path() / "base/ball.json");
  folder.write("base/ball.json", whole.substr(0, whole.size() / 2));
  const Outcome corrupt = compare({});
  EXPECT_EQ(corrupt.exit_code, 5);
  EXPECT_NE(corrupt.errors.find("base/ball.json"), std::string::npos);
  folder.write("compare.toml", replaced(compare_file, "15 m/s", "15"));
  const Outcome unit = rebound({"compare", "compare.toml", "--out", "page"});
  EXPECT_EQ(unit.exit_code, 2);
  EXPECT_NE(unit.errors.find("compare.toml:6:"), std::string::npos) << unit.errors;
  EXPECT_FALSE(there("page"));
}

/// The study's four cores and an elastic ball, against the baselines that ship with the program.
TEST_F(CompareCommand, StoredBaselinesOfTheStudyHold) {
  const std::string tiers = REBOUND_TIERS_FOLDER;
  const Outcome outcome =
      rebound({"compare", tiers + "/compare.toml", "--baseline", tiers + "/baselines"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output << outcome.errors;
}

}  // namespace
}  // namespace rebound::testing
